// Reports of `oncard test`: for people, JUnit XML for build servers, TAP 13, JSON, CSV (RFC 4180).
#pragma once

#include <string>
#include <vector>

#include "base/message.h"

namespace oncard::tools {

/// The result of one scenario with one program.
struct TestOutcome {
  std::string path;
  std::string program = {};  ///< that runs in place of the scenario's; empty: the scenario's
  std::vector<Message> failures = {};  ///< empty = passed
  std::vector<Message> warnings = {};  ///< warnings, which do not fail the scenario
  double time_ms = 0;                  ///< virtual time of the run
  int64_t statements = 0;
  bool interrupted = false;  ///< a signal ended it

  bool passed() const { return failures.empty(); }
  /// `s.toml`, or `s.toml: p.c`.
  std::string Title() const { return program.empty() ? path : path + ": " + program; }
};

/// `ok    path`, `FAIL  path` with the failures and warnings below, and a line with the counts.
std::string FormatTestText(const std::vector<TestOutcome>& outcomes, Language language, bool color);
/// One <testsuite>; `time` is virtual seconds, so that equal runs give equal files.
std::string FormatTestJunit(const std::vector<TestOutcome>& outcomes, Language language);
std::string FormatTestTap(const std::vector<TestOutcome>& outcomes, Language language);
std::string FormatTestJson(const std::vector<TestOutcome>& outcomes, Language language);
/// A line for each test: scenario, program, passed (`yes` or `no`), milliseconds of virtual time,
/// statements, failures and warnings, each in one cell with a line for each.
std::string FormatTestCsv(const std::vector<TestOutcome>& outcomes, Language language);

}  // namespace oncard::tools
