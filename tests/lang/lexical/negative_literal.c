#define N -3
int a, b, c;
int t0() {
  a = 1 - -2;
  b = a -1;
  c = -N;
  return 0; // expect: a=3, b=2, c=3
}
