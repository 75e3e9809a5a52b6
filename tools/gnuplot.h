// Pictures are drawn by gnuplot, a program of its own (Debian package gnuplot-nox).
// Tested by tests/tools/plot_test.cc.
#pragma once

#include <string>

#include "tools/session.h"

namespace oncard::tools {

/// What `gnuplot --version` prints; empty when it is not installed.
std::string GnuplotVersion();

/// What to do when it is not.
Message GnuplotRemedy();

/// Runs a script (runtime/observe/plot.h) and writes the picture to a file; reports what goes
/// wrong. Gives the exit code.
int WritePicture(const Session& session, const std::string& path, const std::string& script);

/// Empty for a name of a picture, .svg or .png; otherwise what is wrong with it.
std::string CheckPictureName(const std::string& path);
/// The same for a name that runtime::TraceText() knows.
std::string CheckTraceName(const std::string& path);

}  // namespace oncard::tools
