int i, j, k;
double d, e;
int t0() {
  d = 2.75;
  i = (int) d;
  e = (double) i;
  d = -2.75;
  j = (long) d;
  k = (int) i;
  return 0; // expect: i=2, e=2, j=-2, k=2
}
