// The registers of servo controllers. Source: GE manual 5.4 and chapter 12. Tested by
// tests/gtcalls/ge/servo_command_test.cc.
#include "gtcalls/ge/commands/register_commands.h"

namespace oncard::gtcalls::ge {

int16_t GT_SetKp(Call& call) { return WriteRegister<&GeRegisters::kp>(call); }
int16_t GT_GetKp(Call& call) { return ReadRegister<&GeRegisters::kp>(call); }
int16_t GT_SetKi(Call& call) { return WriteRegister<&GeRegisters::ki>(call); }
int16_t GT_GetKi(Call& call) { return ReadRegister<&GeRegisters::ki>(call); }
int16_t GT_SetKd(Call& call) { return WriteRegister<&GeRegisters::kd>(call); }
int16_t GT_GetKd(Call& call) { return ReadRegister<&GeRegisters::kd>(call); }
int16_t GT_SetKvff(Call& call) { return WriteRegister<&GeRegisters::kvff>(call); }
int16_t GT_GetKvff(Call& call) { return ReadRegister<&GeRegisters::kvff>(call); }
int16_t GT_SetKaff(Call& call) { return WriteRegister<&GeRegisters::kaff>(call); }
int16_t GT_GetKaff(Call& call) { return ReadRegister<&GeRegisters::kaff>(call); }
int16_t GT_SetILmt(Call& call) { return WriteRegister<&GeRegisters::integral_limit>(call); }
int16_t GT_GetILmt(Call& call) { return ReadRegister<&GeRegisters::integral_limit>(call); }
int16_t GT_SetMtrLmt(Call& call) { return WriteRegister<&GeRegisters::output_limit>(call); }
int16_t GT_GetMtrLmt(Call& call) { return ReadRegister<&GeRegisters::output_limit>(call); }
int16_t GT_SetMtrBias(Call& call) { return WriteRegister<&GeRegisters::bias>(call); }
int16_t GT_GetMtrBias(Call& call) { return ReadRegister<&GeRegisters::bias>(call); }
int16_t GT_SetPosErr(Call& call) { return WriteRegister<&GeRegisters::error_limit>(call); }
int16_t GT_GetPosErr(Call& call) { return ReadRegister<&GeRegisters::error_limit>(call); }

}  // namespace oncard::gtcalls::ge
