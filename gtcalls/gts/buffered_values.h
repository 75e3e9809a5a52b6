// The buffered commands of GTS that write variables: the card's own numbered ones, and those of the
// motion program. A path of the motion core hands them over when it reaches them; they are carried
// out at the end of that tick. Tested by tests/gtcalls/buffer_command_test.cc and
// user_variable_command_test.cc.
#pragma once

#include <cstdint>

#include "gtcalls/card.h"
#include "vm/machine.h"

namespace oncard::gtcalls {

/// What the value is for: GT_BufSetLongVar, GT_BufSetDoubleVar, GT_BufSetVarValue.
enum class ValueTarget : uint8_t { kLong, kDouble, kProgram };

struct BufferedValue {
  ValueTarget target = ValueTarget::kLong;
  int32_t index = 0;  ///< kLong, kDouble: number of the variable
  double value = 0;
  vm::SlotAddress slot = {};  ///< kProgram
};

/// The value as a command of a path, and back.
motion::BufferedCommand EncodeValue(const BufferedValue& value);
BufferedValue DecodeValue(const motion::BufferedCommand& command);

/// To be called before such a command is appended: a tick allocates nothing.
void ReserveValues(motion::MotionCore& motion);

/// Writes the values that paths have reached in the last tick. A value that no longer fits the
/// program, because another one has been loaded, is dropped.
void WriteReachedValues(Card& card);

/// True if a running coordinate system will still write a variable of the motion program.
bool WillWriteProgram(const motion::MotionCore& motion);

}  // namespace oncard::gtcalls
