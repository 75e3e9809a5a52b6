int i;
double d;
int t0() {
  i = (void) d; // expect error MP005
  i = (unsigned) d; // expect error MP005
  i = (double) i; // expect error MP019
  return 0;
}
