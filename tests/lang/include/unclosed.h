int t0() {
  return 0; // expect error MP004 @3

