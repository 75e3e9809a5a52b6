/* Picks a part and places it: axis 1 drives to the part and back, axis 2 lowers and raises the gripper,
   which a second thread opens and closes. A third thread shows on a lamp whether a part is held. All
   loops poll: none of them waits. */
#define MC_GPI 4
#define MC_GPO 12
#define GRIPPER 1
#define LAMP 2
#define CLOSED 1
#define IN_MOTION 0x400

int want;
int held;
int placed;

int arm(void)
{
  int sts;
  int clock;
  int moving;
  int wait;

  GT_AxisOn(1);
  GT_AxisOn(2);
  GT_PrfTrap(1);
  GT_PrfTrap(2);
  GT_SetVel(1, 10);
  GT_SetVel(2, 10);
  GT_SetPos(1, 500);
  GT_Update(1);
lbl_there:
  GT_GetSts(1, &sts, 1, &clock);
  moving = sts & IN_MOTION;
  if (moving) goto lbl_there;
  GT_SetPos(2, 200);
  GT_Update(2);
lbl_down:
  GT_GetSts(2, &sts, 1, &clock);
  moving = sts & IN_MOTION;
  if (moving) goto lbl_down;
  want = 1;
lbl_grip:
  wait = held == 0;
  if (wait) goto lbl_grip;
  GT_SetPos(2, 0);
  GT_Update(2);
lbl_up:
  GT_GetSts(2, &sts, 1, &clock);
  moving = sts & IN_MOTION;
  if (moving) goto lbl_up;
  GT_SetPos(1, 0);
  GT_Update(1);
lbl_back:
  GT_GetSts(1, &sts, 1, &clock);
  moving = sts & IN_MOTION;
  if (moving) goto lbl_back;
  want = 0;
lbl_release:
  if (held) goto lbl_release;
  placed = 1;
  return 0;
}

int gripper(void)
{
  int wait;
  int inputs;
  int level;

lbl_idle:
  wait = want == 0;
  if (wait) goto lbl_idle;
  GT_SetDoBit(MC_GPO, GRIPPER, 1);
lbl_closing:
  GT_GetDi(MC_GPI, &inputs);
  level = inputs & CLOSED;
  wait = level == 0;
  if (wait) goto lbl_closing;
  held = 1;
lbl_carry:
  if (want) goto lbl_carry;
  GT_SetDoBit(MC_GPO, GRIPPER, 0);
lbl_opening:
  GT_GetDi(MC_GPI, &inputs);
  level = inputs & CLOSED;
  if (level) goto lbl_opening;
  held = 0;
  return 0;
}

int lamp(void)
{
  int wait;

lbl_off:
  wait = held == 0;
  if (wait) goto lbl_off;
  GT_SetDoBit(MC_GPO, LAMP, 1);
lbl_on:
  if (held) goto lbl_on;
  GT_SetDoBit(MC_GPO, LAMP, 0);
  return 0;
}
