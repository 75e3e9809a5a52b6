// GTS manual example 10-1, the host's side: compile, download, bind, start, wait, read the result.
//
//   ONCARD_CLOCK=virtual ./host    prints "sum = 5050"
//
// The same source runs with a real card and the vendor's library.
#include <cstdio>

#include "gts.h"

namespace {

/// Ends the calls of this program at the first one that the card refuses.
bool Accepted(const char* command, short code) {
  if (code != 0) std::fprintf(stderr, "%s = %d\n", command, code);
  return code == 0;
}
#define ACCEPTED(call) Accepted(#call, call)

bool Start() {
  char file[128] = "";
  char message[128] = "";
  short line = 0;
  TCompileInfo wrong = {file, &line, message};
  if (!ACCEPTED(GT_Compile("sum.c", &wrong))) {
    std::fprintf(stderr, "%s:%d: %s\n", file, line, message);
    return false;
  }
  short function = 0;
  TVarInfo begin;
  TVarInfo end;
  double first = 1;
  double last = 100;
  return ACCEPTED(GT_Download("sum.bin")) && ACCEPTED(GT_GetFunId("add", &function)) &&
         ACCEPTED(GT_GetVarId("add", "begin", &begin)) &&
         ACCEPTED(GT_GetVarId("add", "end", &end)) && ACCEPTED(GT_Bind(0, function, 0)) &&
         ACCEPTED(GT_SetVarValue(0, &begin, &first)) && ACCEPTED(GT_SetVarValue(0, &end, &last)) &&
         ACCEPTED(GT_RunThread(0));
}

bool Finish() {
  TThreadSts thread;
  do {
    if (!ACCEPTED(GT_GetThreadSts(0, &thread))) return false;
  } while (thread.run == 1);
  TVarInfo sum;
  double value = 0;
  if (!ACCEPTED(GT_GetVarId(NULL, "sum", &sum)) || !ACCEPTED(GT_GetVarValue(-1, &sum, &value))) {
    return false;
  }
  std::printf("sum = %g\n", value);
  return thread.error == 0;
}

}  // namespace

int main() {
  if (!ACCEPTED(GT_Open())) return 1;
  const bool done = Start() && Finish();
  GT_Close();
  return done ? 0 : 1;
}
