int v;
int t0() {
  v = 1； // expect error MP001
  v = v ＋ 1; // expect error MP001
  变量 = 2; // expect error MP001
  return 0;
}
