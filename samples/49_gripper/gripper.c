/* A gripper closes when its output is on, and a sensor confirms it. */
#define MC_GPI 4
#define MC_GPO 12
#define GRIPPER 1
#define CLOSED 1
#define ON 1
#define OFF 0

int go;
int parts;

/* Grips a part and lets it go again, `times` times. Before each part it waits, in ms. */
int pick(int times, int pause)
{
  int inputs;
  int level;
  int cc;

lbl_loop:
  cc = parts >= times;
  if (cc) goto lbl_end;
  GT_Delay(pause);
  GT_SetDoBit(MC_GPO, GRIPPER, ON);
lbl_closing:
  GT_Delay(1);
  GT_GetDi(MC_GPI, &inputs);
  level = inputs & CLOSED;
  cc = level == 0;
  if (cc) goto lbl_closing;
  parts = parts + 1;
  GT_SetDoBit(MC_GPO, GRIPPER, OFF);
lbl_opening:
  GT_Delay(1);
  GT_GetDi(MC_GPI, &inputs);
  level = inputs & CLOSED;
  if (level) goto lbl_opening;
  goto lbl_loop;
lbl_end:
  return parts;
}

/* Closes the gripper when it is told to, and counts the part when it is held. */
int grip(void)
{
  int inputs;
  int level;
  int cc;

  GT_WaitForVarEq(&go, 1);
  GT_SetDoBit(MC_GPO, GRIPPER, ON);
lbl_closing:
  GT_Delay(1);
  GT_GetDi(MC_GPI, &inputs);
  level = inputs & CLOSED;
  cc = level == 0;
  if (cc) goto lbl_closing;
  parts = parts + 1;
  return 0;
}

int order(void)
{
  GT_Delay(5);
  go = 1;
  return 0;
}
