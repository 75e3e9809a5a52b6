// expect ok
// A mask that has one of the axes that were set up is right, and nothing is said about axes that
// another thread sets up, or whose numbers are variables.
int axis, v;
void t0() {
  GT_PrfTrap(3);
  GT_SetVel(3, 5);
  GT_Update(4);
  GT_Update(-1);
  GT_Update(v);
}
void t1() {
  GT_SetVel(1, 5);
  GT_SetVel(2, 5);
  GT_SetVel(3, 5);
  GT_Update(3);
  GT_Update(4);
}
void t2() {
  GT_SetVel(6, 5);
  GT_Update(1);
  GT_Update(32);
}
void t3() {
  GT_Update(8);
  GT_SetVel(5, 5);
  GT_Update(16);
}
