#include "gtcalls/ge/command_register.h"

#include "gtcalls/card.h"

namespace oncard::gtcalls::ge {

uint16_t CauseOf(const Call& call) {
  if (call.cause != 0) return call.cause;
  for (size_t i = 0; i < call.arguments.size(); ++i) {
    const Parameter& parameter = call.command.parameters[i];
    if (parameter.passing != Passing::kValue || parameter.unit == Unit::kIndex) continue;
    const double value = call.value(i);
    if (!(value >= parameter.minimum && value <= parameter.maximum)) return kOverflow;
  }
  return kIllegal;
}

int16_t WriteCommandRegister(Call& call, int16_t code, uint16_t cause) {
  if (code != vm::kOk || call.command.name != "GT_GetCmdSts") {
    call.card.state<GeState>().command_register = cause;
  }
  return code;
}

}  // namespace oncard::gtcalls::ge
