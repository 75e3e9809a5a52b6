/* Thread 0 computes a position in two steps and hands it over; thread 1 waits for the flag before it
   reads the position. */
int x;
int y;
int ready;

int compute()
{
  x = 100;
  y = x * 2;
  ready = 1;
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
