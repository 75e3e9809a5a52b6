// GTS manual example 10-1 as a C++ host, with the header's default arguments and string literals.
#include "check.h"
#include "gts.h"

int main() {
  ACCEPTED(GT_Open());
  char file[128] = "";
  char message[128] = "";
  short line = -1;
  TCompileInfo wrong = {file, &line, message};
  ACCEPTED(GT_Compile("sum.c", &wrong));
  ACCEPTED(GT_Download("sum.bin"));

  short function = 0;
  ACCEPTED(GT_GetFunId("add", &function));
  TVarInfo sum;
  TVarInfo begin;
  TVarInfo end;
  ACCEPTED(GT_GetVarId(NULL, "sum", &sum));
  ACCEPTED(GT_GetVarId("add", "begin", &begin));
  ACCEPTED(GT_GetVarId("add", "end", &end));
  ACCEPTED(GT_Bind(0, function, 0));
  double value = 0;
  ACCEPTED(GT_SetVarValue(-1, &sum, &value));
  value = 1;
  ACCEPTED(GT_SetVarValue(0, &begin, &value));
  value = 100;
  ACCEPTED(GT_SetVarValue(0, &end, &value));
  ACCEPTED(GT_RunThread(0));

  TThreadSts thread;
  do {
    ACCEPTED(GT_GetThreadSts(0, &thread));
  } while (thread.run == 1);
  CHECK_EQ(thread.run, 0);
  CHECK_EQ(thread.error, 0);
  CHECK_EQ(thread.result, 5050);
  ACCEPTED(GT_GetVarValue(-1, &sum, &value));
  CHECK_EQ(value, 5050);
  ACCEPTED(GT_Close());
  return 0;
}
