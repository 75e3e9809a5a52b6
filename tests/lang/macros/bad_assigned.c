#define N 1
int t0() {
  N = 2; // expect error MP031
  return 0;
}
