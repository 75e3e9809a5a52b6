/* Between two statements another thread can run; within one statement none can. */
int careful;
int careless;

/* One statement reads, adds and writes: nothing is lost. */
int count_in_one(int n)
{
  int i;
  int cc;

  i = 0;
lbl_loop:
  cc = i >= n;
  if (cc) goto lbl_end;
  careful = careful + 1;
  i = i + 1;
  goto lbl_loop;
lbl_end:
  return i;
}

/* Three statements: another thread can write `careless` after it was read here, and its work is
   overwritten. */
int count_in_three(int n)
{
  int i;
  int cc;
  int copy;

  i = 0;
lbl_loop:
  cc = i >= n;
  if (cc) goto lbl_end;
  copy = careless;
  copy = copy + 1;
  careless = copy;
  i = i + 1;
  goto lbl_loop;
lbl_end:
  return i;
}
