/* Two threads count parts on the same counter. */
int parts;

int count(int n)
{
  int copy;
  int more;

lbl_loop:
  copy = parts;
  copy = copy + 1;
  parts = copy;
  n = n - 1;
  more = n > 0;
  if (more) goto lbl_loop;
  return 0;
}
