int a, b, c, d;
double e;
int t0() {
  int x;
  double y;
  x = -5;
  y = -0.5;
  a = !x;
  b = ~x;
  c = abs(x);
  d = !0;
  e = fabs(y);
  return 0; // expect: a=0, b=4, c=5, d=1, e=0.5
}
