/* The corrected program acts first and then checks. Whenever the stop comes, one of the two
   threads stops the axis after it was started. */
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
  halt = stopped;
  if (halt) goto lbl_stop;
  return 0;
lbl_stop:
  GT_Stop(1, 1);
lbl_end:
  return 0;
}

int emergency()
{
  stopped = 1;
  GT_Stop(1, 1);
  return 0;
}
