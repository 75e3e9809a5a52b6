/* Axis 2 follows axis 1: 3 pulses for every 2 pulses of the master. */
#define GEAR_MASTER_PROFILE 2

int run(int velocity)
{
  TJogPrm jog;
  double vel;

  GT_AxisOn(1);
  GT_AxisOn(2);
  GT_PrfJog(1);
  jog.acc = 0.5;
  jog.dec = 0.5;
  jog.smooth = 0;
  GT_SetJogPrm(1, &jog);
  vel = (double) velocity;
  GT_SetVel(1, vel);
  GT_PrfGear(2, 0);
  GT_SetGearMaster(2, 1, GEAR_MASTER_PROFILE, 0);
  GT_SetGearRatio(2, 2, 3, 0);
  GT_GearStart(2);
  GT_Update(1);
  GT_Delay(500);
  GT_Stop(1, 0);
  return 0;
}
