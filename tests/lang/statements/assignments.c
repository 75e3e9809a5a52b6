int a, b, c, d, e, f, g, h, k, l, m, n, o, p, q, r, s, t;
int t0() {
  int x, y;
  x = 12;
  y = 5;
  a = x + y;
  b = x - y;
  c = x * y;
  d = x / y;
  e = x % y;
  f = x == y;
  g = x != y;
  h = x < y;
  k = x <= y;
  l = x > y;
  m = x >= y;
  n = x && 0;
  o = x || 0;
  p = x & y;
  q = x | y;
  r = x ^ y;
  s = x << 2;
  t = x >> 2;
  return 0; // expect: a=17, b=7, c=60, d=2, e=2, f=0, g=1, h=0, k=0
} // expect: l=1, m=1, n=0, o=1, p=4, q=13, r=9, s=48, t=3
