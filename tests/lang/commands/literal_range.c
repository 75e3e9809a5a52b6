int t0() {
  GT_Delay(70000); // expect warning MP120
  GT_Delay(65535);
  GT_SetDo(12, 0xFFFFFFFF);
  return 0;
}
