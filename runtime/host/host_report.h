// What oncard found in a host program, for whoever has started it: `oncard test` names a file in
// ONCARD_REPORT. Each process of the host adds a line of JSON to it. Tested by
// tests/tools/host_tests_test.cc.
#pragma once

#include <string_view>
#include <vector>

#include "base/message.h"
#include "base/result.h"

namespace oncard::runtime {

struct HostReport {
  double end_ms = 0;  ///< the latest time of a card when it was closed
  std::vector<Message> failures = {};
  std::vector<Message> warnings = {};
  std::vector<Message> held = {};  ///< requirements that held, and over what
};

/// Appends the report to the file that ONCARD_REPORT names. False if it names none, or the file
/// cannot be written. Safe to call in several processes at once.
bool AppendHostReport(const HostReport& report);

/// Reads the lines that were appended as one report. Fails on anything else.
Result<HostReport> ReadHostReports(std::string_view lines);

}  // namespace oncard::runtime
