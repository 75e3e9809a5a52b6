/* if (a > b) a = a - b; else a = b - a;     (GTS manual 10.4.3)
   The condition is negated, so that the jump skips the first branch. */
int distance(int a, int b)
{
  int cc;

  cc = a <= b;
  if (cc) goto lbl_else;
  a = a - b;
  goto lbl_end;
lbl_else:
  a = b - a;
lbl_end:
  return a;
}
