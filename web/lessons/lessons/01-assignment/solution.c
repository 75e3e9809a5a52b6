/* Gives twice the number. */
int twice(int number)
{
  int answer;

  answer = number + number;
  return answer;
}
