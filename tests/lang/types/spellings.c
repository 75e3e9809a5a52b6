long a, b, c;
short s;
int i;
double d;
int t0() {
  a = 1;
  b = a;
  c = b;
  s = c;
  i = s;
  d = 0.5;
  return i; // expect: i=1
}
