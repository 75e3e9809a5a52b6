// Draws pictures with gnuplot, a separate program (Debian package gnuplot-nox). Tested by
// tests/tools/plot_test.cc.
#pragma once

#include <string>

#include "tools/invocation.h"

namespace oncard::tools {

/// The output of `gnuplot --version`; empty if it is not installed.
std::string GnuplotVersion();

/// The advice if it is not installed: gnuplot_remedy.cc on Linux, gnuplot_remedy_windows.cc on
/// Windows, gnuplot_remedy_wasi.cc in WebAssembly.
Message GnuplotRemedy();

/// Runs a script (runtime/observe/plot.h) and writes the picture to a file; reports errors. Returns
/// the exit code.
int WritePicture(const Invocation& invocation, const std::string& path, const std::string& script);

/// Empty for the name of a picture, .svg or .png; otherwise the error.
std::string CheckPictureName(const std::string& path);
/// The same for a name that runtime::TraceText() knows.
std::string CheckTraceName(const std::string& path);

}  // namespace oncard::tools
