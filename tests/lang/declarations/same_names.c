int v, w;
int t0() {
  int x;
v:
  x = 1;
  v = x;
  return 0; // expect: v=1, w=2
}
int t1() {
  int x;
v:
  x = 2;
  w = x;
  return 0;
}
