//@ structured
/* if_else.c as C has it. */
int distance(int a, int b)
{
  if (a > b) {
    a = a - b;
  } else {
    a = b - a;
  }
  return a;
}

/* The same in one expression. */
int distance_at_once(int a, int b)
{
  return a > b ? a - b : b - a;
}
