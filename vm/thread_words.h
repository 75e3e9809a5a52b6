// A thread's state as words, for hashes. Internal to the machine and to searches of its states.
#pragma once

#include <array>
#include <cstdint>

#include "vm/machine.h"

namespace oncard::vm {

inline constexpr size_t kThreadWordCount = 24;
/// The last ones are counts of statements, which do not influence the future.
inline constexpr size_t kCountWords = 2;

/// The complete state of a thread.
std::array<int64_t, kThreadWordCount> WordsOf(const ThreadState& thread);

}  // namespace oncard::vm
