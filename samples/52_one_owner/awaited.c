/* Thread 0 drives the table to its place, then hands it over to thread 1, which waits for that. */
#define IN_MOTION 0x400

int handed_over;

int load(void)
{
  int sts;
  int clock;
  int moving;

  GT_AxisOn(1);
  GT_PrfTrap(1);
  GT_SetVel(1, 10);
  GT_SetPos(1, 40);
  GT_Update(1);
lbl_moving:
  GT_Delay(1);
  GT_GetSts(1, &sts, 1, &clock);
  moving = sts & IN_MOTION;
  if (moving) goto lbl_moving;
  handed_over = 1;
  return 0;
}

int cut(void)
{
  GT_WaitForVarEq(&handed_over, 1);
  GT_SetVel(1, 2);
  GT_SetPos(1, 60);
  GT_Update(1);
  return 0;
}
