/* A host with calls of all kinds, to test the call log. */
#include <stdlib.h>

#include "check.h"
#include "gts.h"

int main(void) {
  TCompileInfo nowhere = {NULL, NULL, NULL};
  TVarInfo sum;
  short function = 0;
  double values[2] = {1.5, -2};
  double one = 7;
  unsigned long clock = 0;
  char* version = NULL;

  CHECK_EQ(GT_GetClock(&clock, NULL), -1);
  ACCEPTED(GT_Open(0, 1));
  CHECK_EQ(GT_Open(0, 1), -6);
  ACCEPTED(GT_Compile("sum.c", &nowhere));
  CHECK_EQ(GT_Compile("nothing.c", &nowhere), 2007);
  ACCEPTED(GT_Download("sum.bin"));
  ACCEPTED(GT_GetFunId("add", &function));
  ACCEPTED(GT_GetVarId(NULL, "sum", &sum));
  ACCEPTED(GT_SetVarValue(-1, &sum, &one, 1));
  CHECK_EQ(GT_SetVarValue(-1, &sum, values, 0), 7);
  ACCEPTED(GT_GetVarValue(-1, &sum, &one, 1));
  CHECK_EQ(GT_GetVarValue(-1, &sum, NULL, 1), 7);
  CHECK_EQ(GT_Bind(32, function, 0), 7);
  ACCEPTED(GT_Bind(0, function, 0));
  ACCEPTED(GT_RunThread(0));
  ACCEPTED(GT_SetDo(MC_GPO, 0xFFFF));
  ACCEPTED(GT_GetVersion(&version));
  free(version);
  ACCEPTED(GT_GetClock(&clock, NULL));
  ACCEPTED(GT_Close());
  return 0;
}
