// The command `oncard`, and host programs that it starts, as contenders of a measurement.
#pragma once

#include <string>
#include <vector>

namespace oncard::bench {

/// A new folder for files of a measurement, which removes it. Fail() if there can be none.
std::string NewFolder();

/// Runs `oncard` with these arguments; its output is of no interest. Fail() if it does not return
/// 0.
void RunTool(std::vector<std::string> arguments);

/// What a run of the command took, and what it wrote.
struct ToolRun {
  double seconds = 0;     ///< wall-clock time
  double peak_bytes = 0;  ///< the most memory that it occupied
  std::string out;        ///< standard output
};

/// Runs `oncard` with these arguments, whatever it returns. Fail() if it cannot be run, or does not
/// end by itself.
ToolRun MeasureTool(std::vector<std::string> arguments);

}  // namespace oncard::bench
