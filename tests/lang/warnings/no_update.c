double speed;
int t0() {
  GT_PrfJog(1);
  GT_SetVel(1, speed); // expect warning MP132
  return 0;
}
