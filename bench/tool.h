// The command `oncard`, and host programs that it starts, as contenders of a measurement.
#pragma once

#include <string>
#include <vector>

namespace oncard::bench {

/// Runs `oncard` with these arguments; its output is of no interest. Fail() if it does not return
/// 0.
void RunTool(std::vector<std::string> arguments);

}  // namespace oncard::bench
