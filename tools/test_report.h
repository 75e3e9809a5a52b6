// Reports of `oncard test`: for people, JUnit XML for build servers, TAP 13, JSON, CSV (RFC 4180).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/message.h"

namespace oncard::tools {

enum class TestStatus : uint8_t {
  kPassed,
  kFailed,
  kNothing,  ///< it ran, but nothing was checked
  kSkipped   ///< it did not run
};

/// The result of one scenario with one program. Names and messages can contain any bytes; the
/// reports make them safe to show.
struct TestOutcome {
  std::string path;
  std::string program = {};  ///< that runs in place of the scenario's; empty: the scenario's
  std::vector<Message> failures = {};
  std::vector<Message> warnings = {};  ///< warnings, which do not fail the scenario
  Message nothing = {};                ///< why nothing was checked; empty: something was
  Message skipped = {};                ///< why it did not run; empty: it did
  double time_ms = 0;                  ///< virtual time of the run
  double search_ms = 0;                ///< time of this computer that an exploration took
  int64_t statements = 0;
  bool interrupted = false;  ///< a signal ended it

  TestStatus status() const {
    if (!failures.empty()) return TestStatus::kFailed;
    if (!skipped.en.empty()) return TestStatus::kSkipped;
    return nothing.en.empty() ? TestStatus::kPassed : TestStatus::kNothing;
  }
  /// Why it neither passed nor failed; empty otherwise.
  const Message& why() const { return skipped.en.empty() ? nothing : skipped; }
  /// `s.toml`, or `s.toml: p.c`.
  std::string Title() const { return program.empty() ? path : path + ": " + program; }
};

/// `ok   path`, `FAIL path`, `none path` (nothing was checked) or `skip path`, with the failures,
/// reasons and warnings below, and a line with the counts.
std::string FormatTestText(const std::vector<TestOutcome>& outcomes, Language language, bool color);
/// One <testsuite>; `time` is virtual seconds, so that equal runs give equal files, except for an
/// exploration, whose time is that of its search. What did not run or checked nothing is `skipped`.
std::string FormatTestJunit(const std::vector<TestOutcome>& outcomes, Language language);
std::string FormatTestTap(const std::vector<TestOutcome>& outcomes, Language language);
std::string FormatTestJson(const std::vector<TestOutcome>& outcomes, Language language);
/// A line for each test: scenario, program, passed (`yes`, `no`, `nothing` or `skipped`),
/// milliseconds of virtual time, statements, failures and warnings, each in one cell with a line
/// for each. A table calculation takes no cell for a formula.
std::string FormatTestCsv(const std::vector<TestOutcome>& outcomes, Language language);

}  // namespace oncard::tools
