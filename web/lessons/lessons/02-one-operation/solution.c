/* Gives a * b + c * d. */
int two_products(int a, int b, int c, int d)
{
  int tmp1;
  int tmp2;
  int sum;

  tmp1 = a * b;
  tmp2 = c * d;
  sum = tmp1 + tmp2;
  return sum;
}
