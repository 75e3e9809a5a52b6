/* A shuttle drives to and fro until the emergency stop is pressed. Before each move it looks whether it
   may still start; the stop can come between this look and the start. */
#define MC_GPI 4
#define PRESSED 1
#define IN_MOTION 0x400

int stopped;

int shuttle(void)
{
  int target;
  int halt;
  int sts;
  int clock;
  int moving;

  GT_AxisOn(1);
  GT_PrfTrap(1);
  GT_SetVel(1, 10);
  target = 0;
lbl_next:
  target = 100 - target;
  GT_SetPos(1, target);
  halt = stopped;
  if (halt) goto lbl_end;
  GT_Update(1);
lbl_moving:
  GT_Delay(1);
  GT_GetSts(1, &sts, 1, &clock);
  moving = sts & IN_MOTION;
  if (moving) goto lbl_moving;
  goto lbl_next;
lbl_end:
  return 0;
}

int watch(void)
{
  int inputs;
  int pressed;

lbl_look:
  GT_Delay(1);
  GT_GetDi(MC_GPI, &inputs);
  pressed = inputs & PRESSED;
  if (pressed) goto lbl_stop;
  goto lbl_look;
lbl_stop:
  stopped = 1;
  GT_Stop(1, 1);
  return 0;
}
