int v;
int t0() {
  int a;
  a = 1;
  int b; // expect error MP117
  b = a;
  v = b;
  return 0;
}
