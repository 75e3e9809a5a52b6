// expect ok
int go;
int t0() {
  GT_PrfTrap(1);
  GT_SetPos(1, 100);
  GT_SetVel(1, 5);
  if (go) goto start;
  return 0;
start:
  GT_Update(1);
  return 1;
}
