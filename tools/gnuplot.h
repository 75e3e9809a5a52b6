// Pictures are drawn by gnuplot, a program of its own (Debian package gnuplot-nox).
// Tested by tests/tools/plot_test.cc.
#pragma once

#include <string>

#include "runtime/trace.h"
#include "tools/session.h"

namespace oncard::tools {

/// What `gnuplot --version` prints; empty when it is not installed.
std::string GnuplotVersion();

/// What to do when it is not.
Message GnuplotRemedy();

/// Draws a trace to a file that ends in .svg or .png; reports what goes wrong. Gives the exit code.
int WritePicture(const Session& session, const std::string& path, const runtime::Trace& trace,
                 const std::string& title);

}  // namespace oncard::tools
