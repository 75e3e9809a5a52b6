// Searches of scenarios that are kept in files (search/search_file.h): begun, continued, and
// concluded when their parts are merged. Those of a program alone keep traces or random runs
// (search/kept_search.h), those with a card or choices keep units or random runs (kept_cases.h).
// Deterministic. Tested by tests/tools/explore_search_test.cc.
#pragma once

#include <cstdint>

#include "base/result.h"
#include "explore/kept_cases.h"

namespace oncard::explore {

/// A hash of the program, its initial state and what is asked of its runs. Fails as
/// ExploreScenario().
Result<uint64_t> HashOfKept(const SearchedScenario& searched);

/// A new search of a part; the caller fills in SearchFile::input. Fails as BeginByCases(), and if
/// searches of the engine cannot be kept.
Result<SearchFile> BeginKept(const SearchedScenario& searched, const ExploreOptions& options,
                             const SearchPart& part);

/// Checks what a file says of the program, whose hash it has. Fails with what does not fit.
Result<void> CheckKept(const SearchedScenario& searched, const SearchFile& file);

/// Continues a search, as GoOn() and GoOnByCases().
Result<Findings> GoOnKept(const SearchedScenario& searched, const ExploreOptions& options,
                          const SearchKeeper& keep, SearchFile* file);

/// The result of the parts in a file.
Result<Findings> ConcludeKept(const SearchedScenario& searched, const ExploreOptions& options,
                              const SearchFile& file);

}  // namespace oncard::explore
