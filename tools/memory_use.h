// How much memory this process has, and how much there is: memory_use.cc on Linux,
// memory_use_windows.cc on Windows, memory_use_wasi.cc in WebAssembly. Tested by
// tests/tools/memory_use_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace oncard::tools {

/// Bytes of memory that this process occupies; 0: unknown.
int64_t MemoryInUse();

/// Bytes that programs can still take: of the computer, or of the container in which they run, if
/// that has a limit (control groups, version 2) and less is left in it. What only keeps files can
/// be taken. Nothing: unknown. `root` stands before the paths of the system's files.
std::optional<int64_t> MemoryLeft(const std::string& root = {});

}  // namespace oncard::tools
