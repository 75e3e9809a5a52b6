// The width available for output.
#pragma once

namespace oncard::tools {

/// Columns of standard output: the variable COLUMNS if it is at least 40, otherwise the width of
/// the terminal; 0 if it is not a terminal.
int OutputWidth();

}  // namespace oncard::tools
