/* Another thread can run between two statements, but not within one. */
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

/* Three statements: another thread can write `careless` after this one has read it. The
   value that it wrote is then overwritten. */
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
