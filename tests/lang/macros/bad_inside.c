int t0() {
#define N 1 // expect error MP023
  return N;
}
