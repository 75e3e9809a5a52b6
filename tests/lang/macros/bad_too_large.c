#define BIG 3000000000 // expect error MP026
int v;
int t0() {
  v = BIG;
  return 0;
}
