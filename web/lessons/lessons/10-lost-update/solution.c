/* Two threads count parts on the same counter. */
int parts;

int count(int n)
{
  int more;

lbl_loop:
  parts = parts + 1;
  n = n - 1;
  more = n > 0;
  if (more) goto lbl_loop;
  return 0;
}
