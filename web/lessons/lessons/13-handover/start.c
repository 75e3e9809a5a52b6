/* The loader (axis 1) brings a part and leaves it at 40; only then may the gripper (axis 2) come. */
#define IN_MOTION 0x400
int ready;

int loader(void)
{
  GT_AxisOn(1);
  GT_PrfTrap(1);
  GT_SetVel(1, 10);
  GT_SetPos(1, 40);
  GT_Update(1);
  ready = 1;
  return 0;
}

int gripper(void)
{
  GT_AxisOn(2);
  GT_PrfTrap(2);
  GT_SetVel(2, 10);
  GT_SetPos(2, 40);
  GT_WaitForVarEq(&ready, 1);
  GT_Update(2);
  return 0;
}
