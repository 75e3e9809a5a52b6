//@ structured
/* The loops of loops.c as C has them. 'oncard lower structured.c' shows the statements of the card
   that they become. */

int test_first(void)
{
  int i = 1;
  int sum = 0;

  while (i <= 10) {
    sum += i;
    i++;
  }
  return sum;
}

int test_last(void)
{
  int i = 1;
  int sum = 0;

  do {
    sum += i;
    i++;
  } while (i <= 10);
  return sum;
}

int count_down(void)
{
  int sum = 0;

  for (int i = 10; i > 0; i -= 2) sum += i;
  return sum;
}
