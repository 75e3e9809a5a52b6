/* Two threads share a table. Only one of them may be at the table at a time. */
int want0;
int want1;
int turn;
int at_table;
int total;

int first(int amount)
{
  int wait;
  int theirs;
  int copy;

  want0 = 1;
  turn = 1;
lbl_wait:
  theirs = turn == 1;
  wait = want1;
  wait = wait && theirs;
  if (wait) goto lbl_wait;
  at_table = at_table + 1;
  copy = total;
  total = copy + amount;
  at_table = at_table - 1;
  want0 = 0;
  return 0;
}

int second(int amount)
{
  int wait;
  int theirs;
  int copy;

  want1 = 1;
  turn = 0;
lbl_wait:
  theirs = turn == 0;
  wait = want0;
  wait = wait && theirs;
  if (wait) goto lbl_wait;
  at_table = at_table + 1;
  copy = total;
  total = copy + amount;
  at_table = at_table - 1;
  want1 = 0;
  return 0;
}
