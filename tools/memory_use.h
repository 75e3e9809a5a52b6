// How much memory this process has, and how much there is.
#pragma once

#include <cstdint>

namespace oncard::tools {

/// Bytes of memory that this process occupies; 0: unknown.
int64_t MemoryInUse();

/// Bytes that programs can still take: of the computer, or of the control group of this process (a
/// container, a job of a cluster) if that has a limit and less is left in it. 0: unknown.
int64_t MemoryLeft();

}  // namespace oncard::tools
