// What the standard streams are connected to: terminal.cc on Linux and in WebAssembly,
// terminal_windows.cc on Windows.
#pragma once

namespace oncard::tools {

/// To be called first by main(). Afterwards the standard streams carry bytes as they are, a
/// terminal shows UTF-8, and output that is lost is an error.
void PrepareStreams();

/// Columns of standard output: the variable COLUMNS if it is at least 40, otherwise the width of
/// the terminal; 0 if it is not a terminal.
int OutputWidth();
/// Columns of the terminal that standard output is; 0 if it is none. terminal_width.cc on Linux,
/// terminal_width_windows.cc on Windows, terminal_width_wasi.cc in WebAssembly.
int TerminalWidth();

/// True if standard error is a terminal.
bool ErrorsGoToTerminal();
/// The same for one that shows colours.
bool ErrorsHaveColors();

}  // namespace oncard::tools
