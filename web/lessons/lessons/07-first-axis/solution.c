/* Moves an axis by a distance, and is at rest after 1.2 seconds.
   mask: 1 for axis 1, 2 for axis 2 */
int move(int axis, int mask, int distance)
{
  TTrapPrm trap;

  GT_AxisOn(axis);
  GT_PrfTrap(axis);
  trap.acc = 0.25;
  trap.dec = 0.25;
  trap.velStart = 0;
  trap.smoothTime = 0;
  GT_SetTrapPrm(axis, &trap);
  GT_SetPos(axis, distance);
  GT_SetVel(axis, 50);
  GT_Update(mask);
  return mask;
}
