// The signals by which a command is asked to end: stop_signal_numbers.cc on Linux and in
// WebAssembly, whose system ends the command instead, stop_signal_numbers_windows.cc on Windows.
#pragma once

#include <array>

namespace oncard::tools {

/// Ctrl-C, a polite end, and the one of a closed terminal, which a user may have let be ignored.
struct StopSignalNumbers {
  int interrupt;
  int terminate;
  int closed_terminal;

  std::array<int, 3> all() const { return {interrupt, terminate, closed_terminal}; }
};

extern const StopSignalNumbers kStopSignals;

}  // namespace oncard::tools
