/* A program that the host controls with flags: it jogs axis 1 or moves it to `target`, depending on
   `command`, and reports what it does and whether the axis has reached a limit. The host writes
   `command`, `speed` and `target` and reads `state` and `limits`. */
#define COMMAND_NONE 0
#define COMMAND_JOG 1
#define COMMAND_MOVE 2
#define COMMAND_STOP 3

#define STATE_READY 0
#define STATE_JOGGING 1
#define STATE_MOVING 2

#define IN_MOTION 0x400
#define BOTH_LIMITS 0x60

int command;
int speed;
int target;
int state;
int limits;

TTrapPrm trap;
TJogPrm jog;

int serve(void)
{
  int cc;
  int sts;
  int clock;
  double vel;

  GT_AxisOn(1);
lbl_loop:
  GT_GetSts(1, &sts, 1, &clock);
  limits = sts & BOTH_LIMITS;
  cc = sts & IN_MOTION;
  if (cc) goto lbl_busy;
  state = STATE_READY;
lbl_busy:
  cc = command == COMMAND_JOG;
  if (cc) goto lbl_jog;
  cc = command == COMMAND_MOVE;
  if (cc) goto lbl_move;
  cc = command == COMMAND_STOP;
  if (cc) goto lbl_stop;
  goto lbl_loop;

lbl_jog:
  command = COMMAND_NONE;
  GT_ClrSts(1, 1);
  GT_PrfJog(1);
  jog.acc = 0.5;
  jog.dec = 0.5;
  jog.smooth = 0;
  GT_SetJogPrm(1, &jog);
  vel = (double) speed;
  GT_SetVel(1, vel);
  GT_Update(1);
  state = STATE_JOGGING;
  goto lbl_loop;

lbl_move:
  command = COMMAND_NONE;
  GT_ClrSts(1, 1);
  GT_PrfTrap(1);
  trap.acc = 0.5;
  trap.dec = 0.5;
  trap.velStart = 0;
  trap.smoothTime = 0;
  GT_SetTrapPrm(1, &trap);
  vel = (double) speed;
  GT_SetVel(1, vel);
  GT_SetPos(1, target);
  GT_Update(1);
  state = STATE_MOVING;
  goto lbl_loop;

lbl_stop:
  command = COMMAND_NONE;
  GT_Stop(1, 0);
  goto lbl_loop;
}
