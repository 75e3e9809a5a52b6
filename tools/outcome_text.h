// The outcome of a test as text, from the process that runs it to the one that reports it. Tested
// by tests/tools/isolation_test.cc.
#pragma once

#include <string>
#include <string_view>

#include "tools/test_report.h"

namespace oncard::tools {

/// Everything but what names the test.
std::string PackOutcome(const TestOutcome& outcome);

/// False if the text is incomplete.
bool UnpackOutcome(std::string_view text, TestOutcome* outcome);

}  // namespace oncard::tools
