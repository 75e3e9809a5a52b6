/* Axis 1 runs at 100 pulse/ms for two seconds, then stops smoothly. */
TJogPrm jog;

int run(int time)
{
  GT_AxisOn(1);
  GT_PrfJog(1);
  jog.acc = 0.0625;
  jog.dec = 0.0625;
  jog.smooth = 0;
  GT_SetJogPrm(1, &jog);
  GT_SetVel(1, 100);
  GT_Update(1);
  GT_Delay(time);
  GT_Stop(1, 0);
  return 0;
}
