#define NINE 99
int t0() {
  GT_AxisOn(0); // expect error MP014
  GT_AxisOn(NINE); // expect error MP014
  GT_AxisOn(-1); // expect error MP014
  GT_AxisOn(1);
  return 0;
}
