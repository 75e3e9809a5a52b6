//@ structured
// A structure of the card that a call needs after it has called itself.
//@ depth: 4

void profile(int n) {
  TTrapPrm trap; // expect error MP236
  GT_GetTrapPrm(1, &trap);
  if (n > 0) profile(n - 1);
  GT_SetTrapPrm(1, &trap);
}
void t0() {
  profile(3);
}
