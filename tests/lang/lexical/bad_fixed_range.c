double d;
int t0() {
  d = 2147483648.0; // expect error MP026
  d = -2147483648.0;
  d = 2147483647.99998;
  d = 1e300; // expect error MP026
  d = 1e-300;
  return 0;
}
