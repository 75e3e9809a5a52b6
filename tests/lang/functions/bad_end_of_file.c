int v;
int t0() {
  v = 1; // expect error MP004 @3
