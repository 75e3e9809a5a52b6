/* Two polite threads: each sets its flag, and clears it again if the other one has set its own.
   Both can do so for ever. */
int flag0;
int flag1;
int passed;

int first()
{
  int other;

lbl_try:
  flag0 = 1;
  other = flag1;
  if (other) goto lbl_yield;
  passed = passed + 1;
  flag0 = 0;
  return 0;
lbl_yield:
  flag0 = 0;
  goto lbl_try;
}

int second()
{
  int other;

lbl_try:
  flag1 = 1;
  other = flag0;
  if (other) goto lbl_yield;
  passed = passed + 1;
  flag1 = 0;
  return 0;
lbl_yield:
  flag1 = 0;
  goto lbl_try;
}
