// Reports of `oncard test`: for people, JUnit XML for build servers, TAP 13, JSON.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"

namespace oncard::tools {

/// The result of one scenario.
struct TestOutcome {
  std::string path;
  std::vector<Message> failures;  ///< empty = passed
  std::vector<Message> warnings;  ///< warnings, which do not fail the scenario
  double time_ms = 0;             ///< virtual time of the run
  int64_t statements = 0;
  bool interrupted = false;  ///< a signal ended it

  bool passed() const { return failures.empty(); }
};

/// `ok    path`, `FAIL  path` with the failures and warnings below, and a line with the counts.
std::string FormatTestText(const std::vector<TestOutcome>& outcomes, Language language, bool color);
/// One <testsuite>; `time` is virtual seconds, so that equal runs give equal files.
std::string FormatTestJunit(const std::vector<TestOutcome>& outcomes, Language language);
std::string FormatTestTap(const std::vector<TestOutcome>& outcomes, Language language);
std::string FormatTestJson(const std::vector<TestOutcome>& outcomes, Language language);

}  // namespace oncard::tools
