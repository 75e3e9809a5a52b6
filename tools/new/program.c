/* Axis 1 moves to a position and stops there. Positions are in pulses, velocities in pulse/ms. */
void move(int position) {
  TTrapPrm trap;

  GT_AxisOn(1);
  GT_PrfTrap(1);
  trap.acc = 0.25;
  trap.dec = 0.25;
  trap.velStart = 0;
  trap.smoothTime = 0;
  GT_SetTrapPrm(1, &trap);
  GT_SetPos(1, position);
  GT_SetVel(1, 50);
  GT_Update(1);
}
