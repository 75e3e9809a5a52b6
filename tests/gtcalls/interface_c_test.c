/* gts.h in a C program. Only compiled, because it tests the types. */
#include "gts.h"

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
