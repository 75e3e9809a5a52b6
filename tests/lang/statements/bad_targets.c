int i, a[3];
int t0() {
  5 = i; // expect error MP031
  i + 1 = 2; // expect error MP031
  t0 = 1; // expect error MP031
  a = 1; // expect error MP048
  i = a; // expect error MP048
  i[0] = 1; // expect error MP031
  i = t0; // expect error MP031
  return 0;
}
