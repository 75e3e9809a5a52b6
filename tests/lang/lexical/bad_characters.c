int v;
int t0() {
  v = 1 @ 2; // expect error MP001
  v = 2 # 3; // expect error MP001
  return 0;
}
