int t0() {
  GT_Delay(0.5); // expect error MP019
  GT_Delay(2.0); // expect error MP019
  return 0;
}
