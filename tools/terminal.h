// What the standard streams are connected to: terminal.cc on Linux, terminal_windows.cc on Windows.
#pragma once

namespace oncard::tools {

/// To be called first by main(). Afterwards the standard streams carry bytes as they are, a
/// terminal shows UTF-8, and output that is lost is an error.
void PrepareStreams();

/// Columns of standard output: the variable COLUMNS if it is at least 40, otherwise the width of
/// the terminal; 0 if it is not a terminal.
int OutputWidth();

/// True if standard error is a terminal.
bool ErrorsGoToTerminal();
/// The same for one that shows colours.
bool ErrorsHaveColors();

}  // namespace oncard::tools
