// Whether what a search file says can be true of the program that it names. A file comes from
// anywhere: everything that leads the search is taken step by step before it is believed. What a
// file says of the past, its counts, cannot be checked and is taken as it is.
// Tested by tests/explore/search_check_test.cc.
#pragma once

#include <cstdint>

#include "base/result.h"
#include "explore/models/problem.h"
#include "explore/search/search_file.h"

namespace oncard::explore {

/// Fails, naming the place in the file, when a thread that it names cannot take a step there, when
/// a plan is none, or when the run that is said to fail does not. `depth` is the longest run, in
/// statements, that the search will follow.
Result<void> CheckSearch(const Problem& problem, const SearchFile& file,
                         int64_t depth = ExploreOptions{}.depth_limit);

}  // namespace oncard::explore
