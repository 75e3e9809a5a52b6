// A trace in the file format of a name. Tested by tests/tools/run_command_test.cc and
// exec_command_test.cc.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "base/text_pieces.h"
#include "runtime/observe/trace.h"

namespace oncard::runtime {

/// True for the names that TraceText() knows: .csv, .vcd, .json, .gnuplot.
bool IsTraceName(std::string_view path);

/// The text for a file of this name; the trace must outlive it. `X.gnuplot` is the script of
/// picture X. Fails if there is nothing to draw.
Result<TextSource> TraceText(const Trace& trace, std::string_view path, const std::string& title);

/// The script of a picture of this name (plot.h): a PNG if it ends in .png, an SVG otherwise. Fails
/// if there is nothing to draw.
Result<std::string> PictureScript(const Trace& trace, std::string_view path,
                                  const std::string& title);

}  // namespace oncard::runtime
