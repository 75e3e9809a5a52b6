// What the lines of a program wrote when they were executed last, as an editor shows it beside
// them: `answer = 42`. Tested by tests/session/line_writes_test.cc.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "session/rewindable_run.h"

namespace oncard::session {

/// What a thread's statements of a line wrote when it executed them last, one after the other.
struct LineWrites {
  struct Value {
    std::string name;  ///< `x`, `a[3]`; locals without their page
    std::string text;  ///< the value as FormatNumber() writes it
  };
  int thread = 0;
  std::string file;
  int line = 0;
  int64_t moment = 0;         ///< before the last of these statements
  std::vector<Value> values;  ///< each variable once, with what it had at the end
  std::string result;         ///< of the thread, if it has returned one here
};

/// How far back WritesOfLines() looks: at 250 us ten seconds in which no thread does anything.
inline constexpr int64_t kWritesMomentsMax = 40'000;

/// Of the last `statements` statements before the present, in the order of LineWrites::moment.
/// Lines that wrote nothing are there, too. Executes these statements again; the run then stands
/// where it stood.
std::vector<LineWrites> WritesOfLines(RewindableRun& run, int64_t statements);

}  // namespace oncard::session
