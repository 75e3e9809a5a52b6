#define MC_GPO 12
long sts, pclock, lClock, lLoop;
short count;
double pos, positions[8];
TTrapPrm trap;
int t0(int axi) { // expect ok
  GT_GetSts(axi, &sts, count, &pclock);
  GT_GetSts(1, &sts, 1, &pclock);
  GT_SetDo(MC_GPO, 0x01);
  GT_GetClock(&lClock, &lLoop);
  GT_GetEncPos(1, &pos, 1, &pclock);
  GT_GetEncPos(1, &positions[0], 8, &pclock);
  GT_GetEncPos(1, &positions[axi], 8, &pclock);
  GT_SetTrapPrm(1, &trap);
  GT_GetTrapPrm(1, &trap);
  GT_SetVel(1, 50);
  GT_SetVel(1, trap.acc);
  GT_SetVel(1, positions[axi]);
  GT_Update(1 );
  return 0;
}
