/* How often can n be halved until it is 1? */
int halvings(int n)
{
  int count;
  int more;

  count = 0;
lbl_loop:
  n = n / 2;
  count = count + 1;
  more = n > 1;
  if (more) goto lbl_loop;
  return count;
}
