// The registers of servo controllers. Source: GE manual 5.4 and chapter 12. Tested by
// tests/gtcalls/ge/servo_command_test.cc.
#include "gtcalls/ge/commands/commands.h"

namespace oncard::gtcalls::ge {
namespace {

template <auto kRegister>
int16_t Write(Call& call) {
  auto& waiting = (GeAxisOf(call).registers.*kRegister).waiting;
  waiting = static_cast<std::remove_reference_t<decltype(waiting)>>(call.value(1));
  return vm::kOk;
}

template <auto kRegister>
int16_t Read(Call& call) {
  call.Set(1, (GeAxisOf(call).registers.*kRegister).waiting);
  return vm::kOk;
}

}  // namespace

int16_t GT_SetKp(Call& call) { return Write<&GeRegisters::kp>(call); }
int16_t GT_GetKp(Call& call) { return Read<&GeRegisters::kp>(call); }
int16_t GT_SetKi(Call& call) { return Write<&GeRegisters::ki>(call); }
int16_t GT_GetKi(Call& call) { return Read<&GeRegisters::ki>(call); }
int16_t GT_SetKd(Call& call) { return Write<&GeRegisters::kd>(call); }
int16_t GT_GetKd(Call& call) { return Read<&GeRegisters::kd>(call); }
int16_t GT_SetKvff(Call& call) { return Write<&GeRegisters::kvff>(call); }
int16_t GT_GetKvff(Call& call) { return Read<&GeRegisters::kvff>(call); }
int16_t GT_SetKaff(Call& call) { return Write<&GeRegisters::kaff>(call); }
int16_t GT_GetKaff(Call& call) { return Read<&GeRegisters::kaff>(call); }
int16_t GT_SetILmt(Call& call) { return Write<&GeRegisters::integral_limit>(call); }
int16_t GT_GetILmt(Call& call) { return Read<&GeRegisters::integral_limit>(call); }
int16_t GT_SetMtrLmt(Call& call) { return Write<&GeRegisters::output_limit>(call); }
int16_t GT_GetMtrLmt(Call& call) { return Read<&GeRegisters::output_limit>(call); }
int16_t GT_SetMtrBias(Call& call) { return Write<&GeRegisters::bias>(call); }
int16_t GT_GetMtrBias(Call& call) { return Read<&GeRegisters::bias>(call); }
int16_t GT_SetPosErr(Call& call) { return Write<&GeRegisters::error_limit>(call); }
int16_t GT_GetPosErr(Call& call) { return Read<&GeRegisters::error_limit>(call); }

}  // namespace oncard::gtcalls::ge
