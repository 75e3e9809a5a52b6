int a, b, c, d, e, f, g, h;
int t0() {
  a = 2147483647;
  b = -2147483648;
  c = 0x7fffffff;
  d = 0xFFFFFFFF;
  e = 0x80000000;
  f = 12L;
  g = 7U;
  h = 0x10UL;
  return 0; // expect: a=2147483647, b=-2147483648, c=2147483647, d=-1
} // expect: e=-2147483648, f=12, g=7, h=16
