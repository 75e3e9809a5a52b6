// expect ok
// Any of the two may be axis 2.
void t0(int axis) {
  GT_SetVel(axis, 5);
  GT_SetVel(3, 5);
  GT_Update(2);
  GT_Update(3);
}
void t1() {
  GT_SetVel(1, 5);
  GT_Update(8);
}
