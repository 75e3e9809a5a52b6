// Digital inputs and outputs as commands of several families read and write them: whole words of
// levels, whatever the senses of the inputs are. Tested by tests/gtcalls/ge/io_command_test.cc,
// sx_io_command_test.cc and tests/gtcalls/gt400/io_command_test.cc.
#pragma once

#include <cstdint>

namespace oncard::gtcalls {

struct Call;

/// The levels of the 16 general inputs.
int16_t ReadGeneralInputs(Call& call);
/// The levels of the home inputs, one bit per axis.
int16_t ReadHomeLevels(Call& call);
/// Those of the limit inputs, two bits per axis: the positive one first.
int16_t ReadLimitLevels(Call& call);
/// The 16 general outputs: all of them, or one with its number and its level.
int16_t WriteGeneralOutputs(Call& call);
int16_t WriteGeneralOutput(Call& call);
int16_t ReadGeneralOutputs(Call& call);

}  // namespace oncard::gtcalls
