/* A feeder brings a part at the speed of the mode that the operator has set. The program reads the mode
   twice, and the operator can set it to 0, a pause, in between: `oncard explore twice.c` finds this. The
   comments ask what once.toml asks with its keys. */
int mode;
int next;
//@ input: mode = 0..3, next = 0..3

int t0(void)
{
  int pause;
  double vel;

  GT_AxisOn(1);
  GT_PrfTrap(1);
  GT_SetPos(1, 50);
  pause = mode == 0;
  if (pause) goto lbl_end;
  vel = (double) mode;
  vel = vel * 10.0;
  //@ assert: vel >= 10 && vel <= 30
  GT_SetVel(1, vel);
  GT_Update(1);
  GT_Delay(20);
lbl_end:
  return 0;
}

int t1(void)
{
  mode = next;
  return 0;
}
