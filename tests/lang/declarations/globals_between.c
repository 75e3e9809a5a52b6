int a;
int t0() {
  a = 1;
  return 0; // expect: a=1, b=2
}
int b;
int t1() {
  b = 2;
  return 0;
}
