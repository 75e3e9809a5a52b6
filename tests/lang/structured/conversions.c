//@ structured
// C's conversions: narrow types wrap, bool is 0 or 1, doubles truncate, unsigned ints compare,
// divide and shift without a sign.
// expect: a=-126, b=130, c=-32768, d=1, e=2, f=-2, g=3.5, h=1, k=2147483646, l=1, m=-1, n=7
int a, b, c, d, e, f, h, k, l, m, n;
double g;
void t0() {
  char small = 130;
  unsigned char byte = 386;
  short s = 32767;
  bool truth = 0.5;
  unsigned int big = -4;
  a = small;
  b = byte;
  s++;
  c = s;
  d = truth;
  e = 2.75;
  f = -2.75;
  g = 7 / 2 + 0.5;
  h = big > 5;
  k = big / 2;
  l = -1 > 5u;
  m = -1 >> 1;
  n = (unsigned int) -1 >> 29;
}
