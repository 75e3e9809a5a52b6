/* GTS manual, example 7-7: the knife on axis 2 catches up with the material on axis 1, moves with it
   while it cuts, and stops. This repeats. */
#define PROFILE 2
#define PASS 2
#define NORMAL 0
#define FOR_EVER 0
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
  GT_SetVel(1, 50);
  GT_PrfFollow(2, 0);
  GT_SetFollowMaster(2, 1, PROFILE, 0);
  GT_FollowClear(2, 0);
  GT_FollowData(2, 20000, 10000, NORMAL, 0);
  GT_FollowData(2, 40000, 30000, NORMAL, 0);
  GT_FollowData(2, 60000, 40000, NORMAL, 0);
  GT_SetFollowLoop(2, FOR_EVER);
  GT_SetFollowEvent(2, PASS, 1, 50000);
  GT_FollowStart(2, 0);
  GT_Update(1);
  return 0;
}
