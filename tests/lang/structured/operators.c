//@ structured
// Nested expressions, assignments as values, steps, the comma, and short circuits.
// expect: a=17, b=5, c=5, d=7, e=8, f=1, g=0, h=4, k=3, calls=1
int a, b, c, d, e, f, g, h, k, calls;
int count() {
  calls++;
  return 1;
}
void t0() {
  int zero = 0, i = 7;
  a = 2 + 3 * (4 + 1) % 8 * 2 + !zero;
  b = c = 5;
  d = i++;
  e = i;
  f = zero != 0 || count();
  g = zero && 10 / zero > count();
  h = (i -= 4, i);
  k = i > 3 ? i - 1 : count();
}
