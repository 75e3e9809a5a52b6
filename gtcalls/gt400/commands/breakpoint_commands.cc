// Breakpoints of the current axis. Source: GT manual 4.3.2 and chapter 11. Tested by
// tests/gtcalls/gt400/breakpoint_command_test.cc.
#include "gtcalls/gt400/breakpoints.h"
#include "gtcalls/gt400/commands/commands.h"

namespace oncard::gtcalls::gt400 {
namespace {

int16_t Choose(Call& call, Breakpoint breakpoint) {
  SetBreakpoint(call.card, CurrentAxis(call), breakpoint);
  return vm::kOk;
}

}  // namespace

int16_t GT_PosBrk(Call& call) { return Choose(call, Breakpoint::kPositive); }
int16_t GT_NegBrk(Call& call) { return Choose(call, Breakpoint::kNegative); }
int16_t GT_MtnBrk(Call& call) { return Choose(call, Breakpoint::kMotion); }
int16_t GT_ExtBrk(Call& call) { return Choose(call, Breakpoint::kCapture); }
int16_t GT_BrkOff(Call& call) { return Choose(call, Breakpoint::kNone); }

}  // namespace oncard::gtcalls::gt400
