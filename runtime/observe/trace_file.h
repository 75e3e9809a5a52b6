// A trace in the file format of a name. Tested by tests/tools/run_command_test.cc and
// exec_command_test.cc.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "runtime/observe/trace.h"

namespace oncard::runtime {

/// True for the names that TraceText() knows: .csv, .vcd, .json, .gnuplot.
bool IsTraceName(std::string_view path);

/// The text for a file of this name. `X.gnuplot` is the script of a picture (plot.h): of a PNG when
/// X ends in .png, of an SVG otherwise. Fails if there is nothing to draw.
Result<std::string> TraceText(const Trace& trace, std::string_view path, const std::string& title);

}  // namespace oncard::runtime
