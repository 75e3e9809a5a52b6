/* GTS manual example 10-1 as a C host: one thread adds 1..100. The argument is the program. */
#include "check.h"
#include "gts.h"

int main(int argc, char** argv) {
  char file[128];
  char message[128];
  short line = -1;
  TCompileInfo wrong;
  TVarInfo sum;
  TVarInfo begin;
  TVarInfo end;
  TThreadSts status;
  short function = 0;
  double value = 0;
  int polls = 0;

  if (argc != 2) return 2;
  wrong.pFileName = file;
  wrong.pLineNo = &line;
  wrong.pMessage = message;

  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_Compile(argv[1], &wrong));
  CHECK_EQ(line, -1); /* success writes nothing */
  ACCEPTED(GT_Download("sum.bin"));
  ACCEPTED(GT_GetFunId("add", &function));
  ACCEPTED(GT_GetVarId(NULL, "sum", &sum));
  ACCEPTED(GT_GetVarId("add", "begin", &begin));
  ACCEPTED(GT_GetVarId("add", "end", &end));
  ACCEPTED(GT_Bind(0, function, 0));
  ACCEPTED(GT_SetVarValue(-1, &sum, &value, 1));
  value = 1;
  ACCEPTED(GT_SetVarValue(0, &begin, &value, 1));
  value = 100;
  ACCEPTED(GT_SetVarValue(0, &end, &value, 1));
  ACCEPTED(GT_RunThread(0));
  do {
    ACCEPTED(GT_GetThreadSts(0, &status));
    ++polls;
  } while (status.run == 1);
  CHECK_EQ(polls > 1, 1); /* the thread ran while the host polled */
  CHECK_EQ(status.run, 0);
  CHECK_EQ(status.error, 0);
  CHECK_EQ(status.result, 5050);
  ACCEPTED(GT_GetVarValue(-1, &sum, &value, 1));
  CHECK_EQ(value, 5050);
  ACCEPTED(GT_Close());
  return 0;
}
