int v; // expect: v=4
int t0() {
  v = 4;
}