/* How often can n be halved until it is 1? */
int halvings(int n)
{
  int count;
  int done;

  count = 0;
lbl_loop:
  done = n <= 1;
  if (done) goto lbl_end;
  n = n / 2;
  count = count + 1;
  goto lbl_loop;
lbl_end:
  return count;
}
