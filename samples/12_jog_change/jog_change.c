/* GTS manual, example 7-2: axis 1 runs at 100 pulse/ms, and at 50 after it has passed 100000. */
TJogPrm jog;
double pos;

int run(void)
{
  int past;
  int clock;

  GT_AxisOn(1);
  GT_PrfJog(1);
  jog.acc = 0.0625;
  jog.dec = 0.0625;
  jog.smooth = 0;
  GT_SetJogPrm(1, &jog);
  GT_SetVel(1, 100);
  GT_Update(1);
lbl_wait:
  GT_GetPrfPos(1, &pos, 1, &clock);
  past = pos > 100000;
  if (past) goto lbl_slower;
  goto lbl_wait;
lbl_slower:
  GT_SetVel(1, 50);
  GT_Update(1);
  return 0;
}
