// What encoders count, and in which direction.
// Source: GTS manual chapters 4.3.2 and 4.5.2. Tested by tests/gtcalls/encoder_command_test.cc.
#include "gtcalls/commands/motion_support.h"

namespace oncard::gtcalls {
namespace {

int16_t EncOn(Call& call) {
  call.card.motion.SetEncoderExternal(NumberOf(call), true);
  return vm::kOk;
}

int16_t EncOff(Call& call) {
  call.card.motion.SetEncoderExternal(NumberOf(call), false);
  return vm::kOk;
}

/// Bit n-1 reverses encoder n.
int16_t EncSns(Call& call) {
  const uint32_t sense = BitWord(call.value(0));
  for (size_t i = 0; i < call.card.motion.axis_count(); ++i) {
    call.card.motion.SetEncoderSense(i, (sense >> i & 1) != 0);
  }
  return vm::kOk;
}

constexpr CommandEntry kEntries[] = {
    {"GT_EncOn", EncOn},
    {"GT_EncOff", EncOff},
    {"GT_EncSns", EncSns},
};

}  // namespace

std::span<const CommandEntry> EncoderCommands() { return kEntries; }

}  // namespace oncard::gtcalls
