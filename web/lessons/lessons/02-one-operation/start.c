/* Gives a * b + c * d. */
int two_products(int a, int b, int c, int d)
{
  int tmp;
  int sum;

  tmp = a * b;
  tmp = c * d;
  sum = tmp + tmp;
  return sum;
}
