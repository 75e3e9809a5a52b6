int i;
double d;
int t0() {
  i = d; // expect error MP019
  d = i; // expect error MP019
  d = d + i; // expect error MP019
  i = 2.5; // expect error MP019
  i = i + 2.5; // expect error MP019
  i = d % 2; // expect error MP028
  i = d && i; // expect error MP028
  i = ~d; // expect error MP028
  i = !d; // expect error MP028
  i = abs(d); // expect error MP019
  d = fabs(i); // expect error MP019
  i = fabs(d); // expect error MP019
  d = i > 1; // expect error MP019
  i = d > 1;
  d = 1 + 2; // expect error MP019
  return 0;
}
