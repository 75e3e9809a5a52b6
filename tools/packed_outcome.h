// What became of a test, as a text from the process in which it ran to the one that reports it.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "tools/test_report.h"

namespace oncard::tools {

/// Does the work and packs its outcome; an exception is a failure.
std::string PackedOutcomeOf(const std::function<TestOutcome()>& work);
/// Takes all but the names of the test. False if the text is incomplete.
bool UnpackOutcome(std::string_view text, TestOutcome* outcome);

/// The failure of a test that took longer than its limit.
Message TookTooLong(int limit_s);

/// How a process ended without an outcome: by a crash with that name, or with an exit code.
Message DescribeCrash(const std::string& name);
Message DescribeExit(int code);

}  // namespace oncard::tools
