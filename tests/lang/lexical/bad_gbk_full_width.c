int v;
int t0() {
  v = 1£»  // expect error MP001
  return 0;
}
