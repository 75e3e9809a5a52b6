/* A machine of two axes, each driven to and fro by a thread of its own. A third thread looks at the
   emergency stop and stops both axes, a fourth one shows on a lamp whether the machine runs. */
#define MC_GPI 4
#define MC_GPO 12
#define PRESSED 1
#define IN_MOTION 0x400

int stopped;

int drive(int axis)
{
  int bit;
  int mask;
  int target;
  int halt;
  int sts;
  int clock;
  int moving;

  bit = axis - 1;
  mask = 1 << bit;
  GT_AxisOn(axis);
  GT_PrfTrap(axis);
  GT_SetVel(axis, 10);
  target = 0;
lbl_next:
  target = 100 - target;
  GT_SetPos(axis, target);
  GT_Update(mask);
  halt = stopped;
  if (halt) goto lbl_stop;
lbl_moving:
  GT_Delay(1);
  GT_GetSts(axis, &sts, 1, &clock);
  moving = sts & IN_MOTION;
  if (moving) goto lbl_moving;
  halt = stopped;
  if (halt) goto lbl_end;
  goto lbl_next;
lbl_stop:
  GT_Stop(mask, mask);
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
  GT_Stop(3, 3);
  return 0;
}

int lamp(void)
{
  int halt;

  GT_SetDoBit(MC_GPO, 1, 1);
lbl_wait:
  GT_Delay(2);
  halt = stopped;
  if (halt) goto lbl_off;
  goto lbl_wait;
lbl_off:
  GT_SetDoBit(MC_GPO, 1, 0);
  return 0;
}
