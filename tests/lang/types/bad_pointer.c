int *p; // expect error MP129
int t0() {
  return 0;
}
