int t0() {
  GT_Updte(1); // expect error MP033
  GT_Open(0, 1); // expect error MP033
  printf(1); // expect error MP033
  GT_Update; // expect error MP038
  GT_NoSuchThingAtAll(1); // expect error MP033
  return 0;
}
