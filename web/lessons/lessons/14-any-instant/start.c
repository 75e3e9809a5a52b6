/* A saw cuts to and fro until somebody opens the door. Then it must stand. */
#define MC_GPI 4
#define DOOR 1
#define IN_MOTION 0x400
int open;

int saw(void)
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
  target = 50 - target;
  GT_SetPos(1, target);
  halt = open;
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

int guard(void)
{
  int inputs;
  int door;

lbl_look:
  GT_Delay(1);
  GT_GetDi(MC_GPI, &inputs);
  door = inputs & DOOR;
  if (door) goto lbl_stop;
  goto lbl_look;
lbl_stop:
  open = 1;
  GT_Stop(1, 1);
  return 0;
}
