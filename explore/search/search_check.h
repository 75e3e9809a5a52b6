// Checks a search file against the program that it names. Files are untrusted: everything that
// directs the search is executed step by step first. The recorded past, the counts, cannot be
// checked and is accepted. Tested by tests/explore/search_check_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "explore/models/problem.h"
#include "explore/search/search_file.h"

namespace oncard::explore {

/// Fails with the place in the file if a thread that it names cannot execute a step there, if a
/// plan is malformed, or if the run that is marked as failing does not fail. `depth` is the longest
/// run, in statements, that the search will follow.
Result<void> CheckSearch(const Problem& problem, const SearchFile& file,
                         int64_t depth = ExploreOptions{}.depth_limit);

/// Fails if one of the results to be shown does not have as many values as the program.
Result<void> CheckEnds(size_t values, const std::vector<End>& ends);

/// The same for random runs of a program with its card: its results and the failing run.
Result<void> CheckSamples(CardModel* model, const SampleCounts& samples);

}  // namespace oncard::explore
