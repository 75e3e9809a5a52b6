int t0() {
  GT_Update(1);
  GT_SetVel(1, 5); // expect warning MP132
  return 0;
}
