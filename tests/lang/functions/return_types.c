int v;
void t0() {
  int one;
  one = 1;
  if (one) return;
  v = 9;
}
int t1() {
  return;
}
double t2() {
  return 1; // expect: v=0
}
