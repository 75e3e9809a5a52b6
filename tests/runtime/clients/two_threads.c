/* GTS manual example 10-2 as a C host: two threads of one function on two data pages add 1..50 and
   51..100. The argument is the program. */
#include "check.h"
#include "gts.h"

static void SetLocal(short page, TVarInfo* variable, double value) {
  ACCEPTED(GT_SetVarValue(page, variable, &value, 1));
}

int main(int argc, char** argv) {
  TCompileInfo nowhere = {NULL, NULL, NULL};
  TVarInfo sum;
  TVarInfo begin;
  TVarInfo end;
  TThreadSts first;
  TThreadSts second;
  short function = 0;
  double value = 0;

  if (argc != 2) return 2;
  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_Compile(argv[1], &nowhere));
  ACCEPTED(GT_Download("sum.bin"));
  ACCEPTED(GT_GetFunId("add", &function));
  ACCEPTED(GT_GetVarId(NULL, "sum", &sum));
  ACCEPTED(GT_GetVarId("add", "begin", &begin));
  ACCEPTED(GT_GetVarId("add", "end", &end));
  ACCEPTED(GT_Bind(0, function, 0));
  ACCEPTED(GT_Bind(1, function, 1));
  ACCEPTED(GT_SetVarValue(-1, &sum, &value, 1));
  SetLocal(0, &begin, 1);
  SetLocal(0, &end, 50);
  SetLocal(1, &begin, 51);
  SetLocal(1, &end, 100);
  ACCEPTED(GT_RunThread(0));
  ACCEPTED(GT_RunThread(1));
  do {
    ACCEPTED(GT_GetThreadSts(0, &first));
    ACCEPTED(GT_GetThreadSts(1, &second));
  } while (first.run == 1 || second.run == 1);
  CHECK_EQ(first.error, 0);
  CHECK_EQ(second.error, 0);
  ACCEPTED(GT_GetVarValue(-1, &sum, &value, 1));
  CHECK_EQ(value, 5050);
  /* The thread that returned last returned the whole sum. */
  CHECK_EQ(first.result > second.result ? first.result : second.result, 5050);
  ACCEPTED(GT_Close());
  return 0;
}
