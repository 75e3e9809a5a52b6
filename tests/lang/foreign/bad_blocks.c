int a;
int t0() {
  { // expect error MP116
    a = 1;
  }
  return 0;
}
