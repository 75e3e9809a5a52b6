/* The flag is set one statement too early: thread 1 may read y before it is written. */
int x;
int y;
int ready;

int compute()
{
  x = 100;
  ready = 1;
  y = x * 2;
  return 0;
}

int use()
{
  int go;
  int sum;
lbl_wait:
  go = ready;
  if (go) goto lbl_read;
  goto lbl_wait;
lbl_read:
  sum = x + y;
  return sum;
}
