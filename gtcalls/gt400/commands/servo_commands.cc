// Servo controllers: what is not a register that waits for an Update (register_commands.cc).
// Source: GT manual 3.2.3 and chapter 11; public header. Tested by
// tests/gtcalls/gt400/servo_command_test.cc.
#include <algorithm>
#include <limits>

#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/gt400/drives.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::gt400 {

// Assumption: the same registers, with fractions.
int16_t GT_SetKpEx(Call& call) { return GT_SetKp(call); }
int16_t GT_SetKiEx(Call& call) { return GT_SetKi(call); }
int16_t GT_SetKdEx(Call& call) { return GT_SetKd(call); }
int16_t GT_SetKvffEx(Call& call) { return GT_SetKvff(call); }
int16_t GT_SetKaffEx(Call& call) { return GT_SetKaff(call); }

/// Assumption: in closed loop the value is kept for the open loop.
int16_t GT_SetMtrCmd(Call& call) {
  if (const int16_t code = CheckServoCard(call); code != vm::kOk) return code;
  const double value = call.value(0);
  if (value < -motion::kDacFull) {
    return RefuseFor(call, kIllegal,
                     MakeMessage("the output is {}; the range is [-32767, 32767]",
                                 "输出值为 {}；取值范围为 [-32767, 32767]", value));
  }
  CurrentState(call).open_output = static_cast<int16_t>(value);
  UpdateOutput(call.card, CurrentAxis(call));
  return vm::kOk;
}

int16_t GT_GetMtrCmd(Call& call) {
  const int16_t code = CheckServoCard(call);
  if (code == vm::kOk) call.Set(0, CurrentState(call).open_output);
  return code;
}

int16_t GT_GetIntgr(Call& call) {
  if (const int16_t code = CheckServoCard(call); code != vm::kOk) return code;
  using Output = std::numeric_limits<int16_t>;
  const double sum = call.card.motion.state().controls[CurrentAxis(call)].sum;
  call.Set(0, std::clamp<double>(motion::Whole(sum), Output::min(), Output::max()));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gt400
