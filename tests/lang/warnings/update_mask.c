// The number of an axis is not its mask, and a mask means the axes of its bits.
#define AXIS 3
int v;
void t0() {
  GT_PrfTrap(3);
  GT_SetPos(3, 1000);
  GT_SetVel(3, 5);
  GT_Update(3); // expect warning MP139
  GT_Update(4);
}
void t1() {
  GT_PrfJog(2);
  GT_SetVel(2, 5);
  GT_Update(8); // expect warning MP139
  GT_Update(0); // expect warning MP139
  GT_Update(2);
}
void t2() {
  GT_PrfJog(5);
  GT_PrfJog(6);
  GT_SetVel(5, 5);
  GT_Update(5); // expect warning MP139
}
void t3() {
  GT_SetVel(AXIS, 5);
  GT_Update(AXIS); // expect warning MP139
}
void t4() {
loop:
  v = v < 3;
  if (v) goto skip;
  GT_Update(4);
skip:
  GT_SetVel(3, 5);
  GT_Update(8); // expect warning MP139
  goto loop;
}
