/* An axis must not move after the emergency stop. The program checks first and then acts; the stop can
   come between the two. */
int stopped;

int mover()
{
  int halt;

  GT_AxisOn(1);
  GT_PrfJog(1);
  GT_SetVel(1, 50);
  halt = stopped;
  if (halt) goto lbl_end;
  GT_Update(1);
lbl_end:
  return 0;
}

int emergency()
{
  stopped = 1;
  GT_Stop(1, 1);
  return 0;
}
