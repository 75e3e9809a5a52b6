int i;
int t0() {
  i; // expect error MP126
  i + 1; // expect error MP126
  5; // expect error MP126
  abs(i); // expect error MP126
  return 0;
}
