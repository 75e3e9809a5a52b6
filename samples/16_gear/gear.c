/* GTS manual, example 7-5: axis 2 follows axis 1 at half its speed, through a clutch of 100000
   pulses of the master. */
#define PROFILE 2
TJogPrm jog;

int run(void)
{
  GT_AxisOn(1);
  GT_AxisOn(2);
  GT_PrfJog(1);
  jog.acc = 1;
  jog.dec = 1;
  jog.smooth = 0;
  GT_SetJogPrm(1, &jog);
  GT_SetVel(1, 100);
  GT_PrfGear(2, 0);
  GT_SetGearMaster(2, 1, PROFILE, 0);
  GT_SetGearRatio(2, 2, 1, 100000);
  GT_GearStart(2);
  GT_Update(1);
  return 0;
}
