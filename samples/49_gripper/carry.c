/* Grips a part where the axis stands, and carries it away when the sensor says that the gripper holds it. */
#define MC_GPI 4
#define MC_GPO 12
#define GRIPPER 1
#define CLOSED 1
#define ON 1

int go;

int carry(void)
{
  int inputs;
  int level;

  GT_AxisOn(1);
  GT_PrfTrap(1);
  GT_SetVel(1, 50);
  GT_SetPos(1, 2000);
  GT_WaitForVarEq(&go, 1);
  GT_SetDoBit(MC_GPO, GRIPPER, ON);
lbl_closing:
  GT_Delay(1);
  GT_GetDi(MC_GPI, &inputs);
  level = inputs & CLOSED;
  if (level) goto lbl_held;
  goto lbl_closing;
lbl_held:
  GT_Update(1);
  return 0;
}

int order(void)
{
  GT_Delay(5);
  go = 1;
  return 0;
}
