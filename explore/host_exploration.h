// Explores the threads that a host program has started, from the record of its calls
// (runtime/scenario/record/call_record.h). The host is part of the surroundings: it makes the
// recorded calls whatever the threads do. The modules for WebAssembly have none of this. Tested by
// tests/explore/host_exploration_test.cc.
#pragma once

#include <string>

#include "base/result.h"
#include "explore/reports/report.h"

namespace oncard::explore {

/// Explores the record of one card; its text, and the file's path for messages. What must hold are
/// the comments (models/problem.h) of the sources in the record. Fails if the text is no record or
/// one of several cards, if a comment cannot be read, and as CardModel::CreateFromCalls().
Result<Findings> ExploreRecord(const std::string& text, const std::string& path,
                               const ExploreOptions& options);

}  // namespace oncard::explore
