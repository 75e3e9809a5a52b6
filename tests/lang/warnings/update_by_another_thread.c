// expect ok
int t0() {
  GT_SetVel(1, 5);
  return 0;
}
int t1() {
  GT_Update(1);
  return 0;
}
