/* The corrected feeder reads the mode once, and decides and computes with its copy. */
int mode;
int next;

int set_speed(void)
{
  int chosen;
  int pause;
  double vel;

  GT_AxisOn(1);
  GT_PrfTrap(1);
  GT_SetPos(1, 50);
  chosen = mode;
  pause = chosen == 0;
  if (pause) goto lbl_end;
  vel = (double) chosen;
  vel = vel * 10.0;
  //@ assert: vel >= 10 && vel <= 30
  GT_SetVel(1, vel);
  GT_Update(1);
  GT_Delay(20);
lbl_end:
  return 0;
}

int operate(void)
{
  mode = next;
  return 0;
}
