// The buffered commands of GTS that write variables: the card's own numbered ones, and those of the
// motion program. The motion core collects them when a path reaches them; they are executed at the
// end of that tick. Tested by tests/gtcalls/buffer_command_test.cc and
// user_variable_command_test.cc.
#pragma once

#include <cstdint>

#include "gtcalls/card.h"
#include "vm/machine.h"

namespace oncard::gtcalls::gts {

/// The target of the value: GT_BufSetLongVar, GT_BufSetDoubleVar, GT_BufSetVarValue.
enum class ValueTarget : uint8_t { kLong, kDouble, kProgram };

struct BufferedValue {
  ValueTarget target = ValueTarget::kLong;
  int32_t index = 0;  ///< kLong, kDouble: number of the variable
  double value = 0;
  vm::SlotAddress slot = {};  ///< kProgram
};

/// Converts the value to a command of a path.
motion::BufferedCommand EncodeValue(const BufferedValue& value);
BufferedValue DecodeValue(const motion::BufferedCommand& command);

/// Must be called before such a command is appended, because a tick does not allocate.
void ReserveValues(motion::MotionCore& motion);

/// Writes the values that paths have reached in the last tick. A value that no longer fits the
/// program, because another one has been loaded, is dropped.
void WriteReachedValues(Card& card);

/// True if a running coordinate system will still write a variable of the motion program.
bool WillWriteProgram(const motion::MotionCore& motion);

}  // namespace oncard::gtcalls::gts
