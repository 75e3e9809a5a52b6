/* gts.h and LookAheadEx.h in a C program. Only compiled, because it tests the types. */
#include "LookAheadEx.h"

/* All arguments are given, because C has no defaults; names are arrays and literals. */
short CallCommandsFromC(void);
short CallCommandsFromC(void) {
  char name[8] = "add";
  char* version = NULL;
  double position[8];
  unsigned long clock = 0;
  TTrapPrm trap = {0.25, 0.125, 0, 25};
  TVarInfo variable;
  if (GT_Open(0, 1) != 0) return 1;
  if (GT_GetVersion(&version) != 0) return 2;
  if (GT_GetVarId(NULL, name, &variable) != 0) return 3;
  if (GT_GetVarId("add", "begin", &variable) != 0) return 4;
  if (GT_SetTrapPrm(1, &trap) != 0) return 5;
  if (GT_GetPrfPos(1, position, 8, &clock) != 0) return 6;
  if (GT_SetDo(MC_GPO, 0x01) != 0) return 7;
  return GT_Close();
}

short CallLookAheadFromC(void);
short CallLookAheadFromC(void) {
  const EMachineMode mode = NORMAL_THREE_AXIS;
  TLookAheadParameter parameter = {0};
  TPreStartPos start = {{0}};
  int limits[LA_AXIS_NUM] = {AXIS_LIMIT_MAX_VEL | AXIS_LIMIT_MAX_ACC | AXIS_LIMIT_MAX_DV};
  double time = 0;
  parameter.lookAheadNum = 200;
  parameter.axisRelation[0] = 1;
  if (GT_SetupLookAheadCrd(1, mode) != 0) return 1;
  if (GT_SetVelDefineModeLa(1, NORMAL_DEF_VEL) != 0) return 2;
  if (GT_SetWorkLimitModeLa(1, WORK_LIMIT_VALID) != 0) return 3;
  if (GT_SetAxisLimitModeLa(1, limits) != 0) return 4;
  if (GT_InitLookAheadEx(1, &parameter, 0, 1, &start) != 0) return 5;
  if (GT_LnXYEx(1, 8, 9, 100, 800, 0, 0, 0) != 0) return 6;
  if (GT_CrdDataEx(1, NULL, 0) != 0) return 7;
  return GT_GetMotionTimeEx(1, &time, 0);
}
