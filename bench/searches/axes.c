/* Moves an axis to its place, which takes about 20 ms, and waits until it is there. Each thread does so
   with an axis of its own. */
#define IN_MOTION 0x400

int move(int axis)
{
  int bit;
  int mask;
  int sts;
  int clock;
  int moving;

  bit = axis - 1;
  mask = 1 << bit;
  GT_AxisOn(axis);
  GT_PrfTrap(axis);
  GT_SetVel(axis, 10);
  GT_SetPos(axis, 100);
  GT_Update(mask);
lbl_moving:
  GT_Delay(1);
  GT_GetSts(axis, &sts, 1, &clock);
  moving = sts & IN_MOTION;
  if (moving) goto lbl_moving;
  return 0;
}
