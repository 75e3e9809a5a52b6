/* The sum of 01_sum with its addition split into two statements: another thread can write `sum`
   between them, and what it has added is then lost. */
int sum;

int add(int begin, int end)
{
  int i;
  int cc;
  int copy;

  i = begin;
lbl_loop:
  cc = i > end;
  if (cc) goto lbl_end;
  copy = sum;
  sum = copy + i;
  i = i + 1;
  goto lbl_loop;
lbl_end:
  return 0;
}
