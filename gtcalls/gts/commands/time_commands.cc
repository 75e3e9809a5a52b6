// Clocks, and the commands with which a motion program's thread delays, waits and sets its data
// page.
// Source: GTS manual 10.3.5, table 10-2 and chapter 13; the public header for parameters.
// Tested by tests/gtcalls/time_command_test.cc.
#include "gtcalls/gts/commands/commands.h"
#include "gtcalls/gts/defaults.h"

namespace oncard::gtcalls::gts {

int16_t GT_GetClock(Call& call) {
  const motion::MotionCore& core = call.card.motion;
  call.Set(0, UnsignedLong(core.ClockMs()));
  // pLoop is "for internal use": assumed to count profile cycles since GT_Reset.
  call.Set(1, UnsignedLong(core.state().clock_cycle));
  return vm::kOk;
}

int16_t GT_GetClockHighPrecision(Call& call) {
  call.Set(0, UnsignedLong(call.card.motion.ClockUs() / kFineClockUs));
  return vm::kOk;
}

int16_t GT_Delay(Call& call) {
  if (call.caller == vm::kHostCaller) return RefuseHost(call);
  call.card.machine.Delay(call.caller, CyclesFromMs(call, call.integer(0)));
  return vm::kOk;
}

/// Assumption: the parameter is a number of profile cycles, as its name in one public header says.
int16_t GT_DelayHighPrecision(Call& call) {
  if (call.caller == vm::kHostCaller) return RefuseHost(call);
  call.card.machine.Delay(call.caller, call.integer(0));
  return vm::kOk;
}

int16_t GT_SetDataPage(Call& call) {
  if (call.caller == vm::kHostCaller) return RefuseHost(call);
  const int page = call.integer(0);
  const int16_t code = call.card.machine.SwitchPage(call.caller, page);
  return code == vm::kOk ? code : call.Refuse(code, DescribeTakenPage(page));
}

/// Assumption: the vendor's compiler knows the name. That the command takes a variable and a value
/// and waits until they are equal is inferred from it.
int16_t GT_WaitForVarEq(Call& call) {
  if (call.caller == vm::kHostCaller) return RefuseHost(call);
  call.card.machine.WaitForValue(call.caller, call.arguments[0].slot, call.integer(1));
  return vm::kOk;
}

int16_t RefuseHost(Call& call) {
  return call.Refuse(
      vm::kRefused,
      MakeMessage("{0} acts on the calling thread of a motion program; a host "
                  "program has none",
                  "{0} 作用于运动程序的调用线程；主机程序没有线程", call.command.name));
}

int64_t CyclesFromMs(const Call& call, int64_t milliseconds) {
  const int64_t cycle_us = call.card.motion.config().cycle_us;
  return (milliseconds * 1000 + cycle_us - 1) / cycle_us;
}

}  // namespace oncard::gtcalls::gts
