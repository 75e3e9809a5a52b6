int g = 5; // expect error MP110
int t0() {
  int a = 1; // expect error MP110
  int b[2] = {1, 2}; // expect error MP110
  g = a;
  return b[0];
}
