int a;
int t0() {
  if (a) a = 1; // expect error MP045
  if (a) { a = 2; } // expect error MP045
  if (a) goto l; else a = 3; // expect error MP104
  else a = 4; // expect error MP115
l:
  return 0;
}
