// Where a command is called: a statement of a motion program, or a call of the host. Tested by
// tests/runtime/refused_commands_test.cc and supervisor_test.cc.
#pragma once

#include <string>

#include "base/message.h"
#include "gtcalls/card.h"
#include "vm/machine.h"

namespace oncard::runtime {

struct CommandPlace {
  int thread = vm::kHostCaller;
  // Of a thread's statement.
  std::string function;
  std::string file;  ///< of the source; `line` 0: not known
  int line = 0;
  // Of the host.
  std::string call;  ///< with its inputs: `GT_Update(0x4)`
};

/// The place of an instruction of the machine's program, for a thread that executes it.
CommandPlace PlaceOfInstruction(const vm::Machine& machine, int thread, int function,
                                int instruction);
/// The place of a call in progress.
CommandPlace PlaceOf(const gtcalls::Call& call);

/// `p.c:12: thread 0 f: `, the file relative to the program, or `GT_Update(0x4): `.
Message DescribePlace(const CommandPlace& place, const std::string& program_path);

/// ` (at 0.25 ms)`, ` (first at 0.25 ms, 3 times)`; nothing if the count is 0.
Message DescribeOccurrences(int64_t first_us, int64_t count);

}  // namespace oncard::runtime
