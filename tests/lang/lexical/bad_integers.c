int a;
int t0() {
  a = 2147483648; // expect error MP026
  a = -2147483649; // expect error MP026
  a = 0x100000000; // expect error MP026
  a = 017; // expect error MP118
  a = 12abc; // expect error MP003
  a = 0x; // expect error MP003
  a = 1.2.3; // expect error MP003
  a = 1e; // expect error MP003
  return 0;
}
