int v; // expect: v=8
int t0() {
  v = 8;
  return 0;
}
