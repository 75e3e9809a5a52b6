double a, b, c, d;
int e;
int t0() {
  double x, y;
  x = 1.5;
  y = 0.25;
  a = x + y;
  b = x - 1;
  c = 2 * x;
  d = x / y;
  e = x > y;
  return 0; // expect: a=1.75, b=0.5, c=3, d=6, e=1
}
