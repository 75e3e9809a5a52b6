// Continues a search that is stored in a file, and saves it from time to time. Deterministic except
// for the times of saving. Tested by tests/explore/kept_search_test.cc.
#pragma once

#include <functional>

#include "base/result.h"
#include "explore/search/explorer.h"
#include "explore/search/search_file.h"

namespace oncard::explore {

/// Receives the search to be saved; returns false if saving failed, which ends the search.
using SearchKeeper = std::function<bool(const SearchFile& file)>;

/// Continues a search until it is complete, a limit is reached or it is interrupted; `file` is then
/// the search to be saved. Options that the file contains are taken from the file. When
/// SearchProgress::pausing is set, `keep` is called and the search continues. Fails as Explore().
Result<Exploration> GoOn(const Problem& problem, const ExploreOptions& options,
                         const SearchKeeper& keep, SearchFile* file);

}  // namespace oncard::explore
