/* Drives an axis into its positive limit switch, then back to 0. */
#define POSITIVE_LIMIT 0x20
#define IN_MOTION 0x400

int find_limit(int axis, int mask)
{
  TJogPrm jog;
  TTrapPrm trap;
  int sts;
  int clock;
  int cc;

  GT_AxisOn(axis);
  GT_PrfJog(axis);
  jog.acc = 0.5;
  jog.dec = 0.5;
  jog.smooth = 0;
  GT_SetJogPrm(axis, &jog);
  GT_SetVel(axis, 25);
  GT_Update(mask);
lbl_search:
  GT_GetSts(axis, &sts, 1, &clock);
  cc = sts & IN_MOTION;
  if (cc) goto lbl_search;

  GT_PrfTrap(axis);
  trap.acc = 0.5;
  trap.dec = 0.5;
  trap.velStart = 0;
  trap.smoothTime = 0;
  GT_SetTrapPrm(axis, &trap);
  GT_SetVel(axis, 50);
  GT_SetPos(axis, 0);
  GT_Update(mask);
lbl_back:
  GT_GetSts(axis, &sts, 1, &clock);
  cc = sts & IN_MOTION;
  if (cc) goto lbl_back;
  GT_ClrSts(axis, 1);
  return 0;
}
