// GTS manual example 10-2 as a C++ host.
#include "check.h"
#include "gts.h"

namespace {

void SetLocal(short page, TVarInfo variable, double value) {
  ACCEPTED(GT_SetVarValue(page, &variable, &value));
}

}  // namespace

int main() {
  ACCEPTED(GT_Open());
  TCompileInfo nowhere = {};
  ACCEPTED(GT_Compile("sum.c", &nowhere));
  ACCEPTED(GT_Download("sum.bin"));
  short function = 0;
  ACCEPTED(GT_GetFunId("add", &function));
  TVarInfo sum;
  TVarInfo begin;
  TVarInfo end;
  ACCEPTED(GT_GetVarId(nullptr, "sum", &sum));
  ACCEPTED(GT_GetVarId("add", "begin", &begin));
  ACCEPTED(GT_GetVarId("add", "end", &end));
  ACCEPTED(GT_Bind(0, function, 0));
  ACCEPTED(GT_Bind(1, function, 1));
  SetLocal(-1, sum, 0);
  SetLocal(0, begin, 1);
  SetLocal(0, end, 50);
  SetLocal(1, begin, 51);
  SetLocal(1, end, 100);
  ACCEPTED(GT_RunThread(0));
  ACCEPTED(GT_RunThread(1));

  TThreadSts threads[2];
  do {
    for (short i = 0; i < 2; ++i) ACCEPTED(GT_GetThreadSts(i, &threads[i]));
  } while (threads[0].run == 1 || threads[1].run == 1);
  double value = 0;
  ACCEPTED(GT_GetVarValue(-1, &sum, &value));
  CHECK_EQ(value, 5050);
  const double last = threads[0].result > threads[1].result ? threads[0].result : threads[1].result;
  CHECK_EQ(last, 5050);
  CHECK_EQ(threads[0].error, 0);
  CHECK_EQ(threads[1].error, 0);
  ACCEPTED(GT_Close());
  return 0;
}
