int v;
int t0(void) {
  v = 2;
  return 0; // expect: v=2
}
