// Uses the comments of a source (models/problem.h) when it is run instead of explored. Tested by
// tests/tools/run_command_test.cc.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "runtime/scenario/file/scenario.h"
#include "vm/object.h"

namespace oncard::explore {

/// Completes the scenario of a source that is run by itself from the source's comments (problem.h):
/// requirements, whether it has to end, initial values and, unless it has threads, the threads t0,
/// t1, ... Fails on a comment that cannot be read, or that concerns all schedules.
Result<void> AddComments(const std::string& path, std::string_view source, const vm::Object& object,
                         runtime::Scenario* scenario);

/// A warning if the source of a scenario's program has such comments: they are ignored, because the
/// scenario states the requirements. Asserts are not meant: they always count.
std::optional<Message> DescribeUnusedComments(const runtime::Scenario& scenario,
                                              std::string_view source);

}  // namespace oncard::explore
