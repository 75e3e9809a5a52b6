int v;
int helper(int x) { return x; }
int t0() {
  helper(1); // expect error MP113
  v = helper(2); // expect error MP113
  later(); // expect error MP113
  return 0;
}
void later() { return; }
