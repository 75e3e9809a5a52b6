// The registers of axes that wait for an Update: GT_Set... and GT_Get... of each. Source: GT manual
// 4.3 and chapter 11. Tested by tests/gtcalls/gt400/register_command_test.cc.
#include <cmath>
#include <string_view>

#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/gt400/registers.h"

namespace oncard::gtcalls::gt400 {
namespace {

// --- Which values registers take -------------------------------------------------------------

int16_t RefuseValue(Call& call, CommandCause cause, std::string_view range) {
  return RefuseFor(
      call, cause,
      MakeMessage("parameter {0} is {1}; the range is {2}", "参数 {0} 为 {1}；取值范围为 {2}",
                  call.command.parameters[0].name, call.value(0), range));
}

int16_t CheckRatio(Call& call, double value) {
  if (std::fabs(value) <= kRateMax) return vm::kOk;
  return RefuseValue(call, kOverflow, "[-16384, 16384]");
}

/// Both directions are for mode V; the mode must be set first.
int16_t CheckVelocity(Call& call, double value) {
  if (!(std::fabs(value) <= kRateMax)) return RefuseValue(call, kOverflow, "[-16384, 16384]");
  const motion::ProfileMode mode = call.card.motion.profile(CurrentAxis(call)).mode;
  const bool positive = mode == motion::ProfileMode::kTrap || mode == motion::ProfileMode::kSCurve;
  if (value >= 0 || !positive) return vm::kOk;
  return RefuseFor(call, kIllegal,
                   MakeMessage("the velocity is {0}; below 0 it is for mode V only, call GT_PrflV "
                               "first",
                               "速度为 {0}；仅速度模式下可为负值，请先调用 GT_PrflV", value));
}

int16_t CheckAcceleration(Call& call, double value) {
  if (value < 0) return RefuseValue(call, kIllegal, "[0, 16384]");
  // Assumption: mode V has no acceleration of 16384 itself.
  const bool below = call.card.motion.profile(CurrentAxis(call)).mode == motion::ProfileMode::kJog;
  if (value < kRateMax || (value == kRateMax && !below)) return vm::kOk;
  return RefuseValue(call, kOverflow, below ? "[0, 16384)" : "[0, 16384]");
}

int16_t CheckSCurve(Call& call, double value) {
  if (value >= 0 && value < kSCurveEnd) return vm::kOk;
  return RefuseValue(call, kIllegal, "[0, 0.5)");
}

int16_t CheckServo(Call& call, double value) {
  if (value >= 0 && value <= kServoMax) return vm::kOk;
  return RefuseValue(call, kIllegal, "[0, 32767]");
}

int16_t CheckAny(Call&, double) { return vm::kOk; }

// --- The commands ----------------------------------------------------------------------------

int16_t CheckCard(Call& call, RegisterKind kind) {
  return kind == RegisterKind::kServo ? CheckServoCard(call) : vm::kOk;
}

/// Writes a register if it takes the value.
template <typename Value>
int16_t SetRegister(Call& call, Register which, Value AxisRegisters::*member) {
  Gt400Axis& axis = CurrentState(call);
  axis.waiting.*member = static_cast<Value>(call.value(0));
  axis.request.written = static_cast<uint16_t>(axis.request.written | BitOf(which));
  return vm::kOk;
}

}  // namespace

#define REGISTER(name, member, check, kind)                              \
  int16_t GT_Set##name(Call& call) {                                     \
    int16_t code = CheckCard(call, RegisterKind::kind);                  \
    if (code == vm::kOk) code = check(call, call.value(0));              \
    if (code != vm::kOk) return code;                                    \
    return SetRegister(call, Register::k##name, &AxisRegisters::member); \
  }                                                                      \
  int16_t GT_Get##name(Call& call) {                                     \
    const int16_t code = CheckCard(call, RegisterKind::kind);            \
    if (code == vm::kOk) call.Set(0, CurrentState(call).waiting.member); \
    return code;                                                         \
  }
#include "gtcalls/gt400/registers.def"

}  // namespace oncard::gtcalls::gt400
