/* GTS manual, example 9-1: axis 1 moves towards 1000000, but has a soft limit at 20000. Then it
   moves back until its negative limit switch stops it. */
#define IN_MOTION 0x400
TTrapPrm trap;
int sts;
int at_soft_limit;
int at_switch;

int run(void)
{
  int moving;
  int clock;

  GT_AxisOn(1);
  GT_SetSoftLimit(1, 20000, -20000);
  GT_PrfTrap(1);
  trap.acc = 0.125;
  trap.dec = 0.125;
  trap.velStart = 0;
  trap.smoothTime = 25;
  GT_SetTrapPrm(1, &trap);
  GT_SetVel(1, 50);
  GT_SetPos(1, 1000000);
  GT_Update(1);
lbl_forth:
  GT_GetSts(1, &sts, 1, &clock);
  moving = sts & IN_MOTION;
  if (moving) goto lbl_forth;
  at_soft_limit = sts;

  GT_SetPos(1, 0);
  GT_Update(1);
lbl_back:
  GT_GetSts(1, &sts, 1, &clock);
  moving = sts & IN_MOTION;
  if (moving) goto lbl_back;
  at_switch = sts;
  GT_ClrSts(1, 1);
  return 0;
}
