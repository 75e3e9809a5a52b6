/* GTS manual, example 7-1: axis 1 travels 50000 pulses and stops there. */
TTrapPrm trap;

int move(int distance)
{
  GT_AxisOn(1);
  GT_PrfTrap(1);
  trap.acc = 0.25;
  trap.dec = 0.125;
  trap.velStart = 0;
  trap.smoothTime = 25;
  GT_SetTrapPrm(1, &trap);
  GT_SetPos(1, distance);
  GT_SetVel(1, 50);
  GT_Update(1);
  return 0;
}
