// The state of a thread in words. Tested by tests/runtime/scenario_run_test.cc.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/message.h"
#include "vm/image.h"
#include "vm/machine.h"

namespace oncard::runtime {

/// `unbound` `finished` `running` `paused` `faulted`.
std::string_view ThreadStateName(vm::ThreadRun run);

/// The fault of a faulted thread that runs a program: `index 9 is out of bounds: the array has
/// elements 0 to 7`.
Message DescribeFault(const vm::ThreadState& thread, const vm::Image& program);

/// If the fault is one of recursion: `'sum' calls itself more than 3 deep: ...`.
std::optional<Message> DescribeDepth(const vm::ThreadState& thread, const vm::Image& program);

/// The result of a thread that has ended, as FormatNumber() writes it.
std::string ResultText(const vm::ThreadState& thread);

/// `running at p.c:12`, `finished, result 5`; `place` is that of its current or last statement.
Message DescribeStatus(const vm::ThreadState& thread, const vm::Image& program,
                       const std::string& place);

}  // namespace oncard::runtime
