// A search that lives in a file goes on, and is kept from time to time.
// Deterministic but for when that is. Tested by tests/explore/kept_search_test.cc.
#pragma once

#include <functional>

#include "base/result.h"
#include "explore/search/explorer.h"
#include "explore/search/search_file.h"

namespace oncard::explore {

/// Told what there is to be kept; false when that was not possible, which ends the search.
using SearchKeeper = std::function<bool(const SearchFile& file)>;

/// Goes on with a search until it is done, a limit is reached or it is interrupted; `file` is then
/// what is to be kept. Of the options those count that the file does not say. When
/// SearchProgress::pausing is set, `keep` is called and the search goes on. Fails as Explore().
Result<Exploration> GoOn(const Problem& problem, const ExploreOptions& options,
                         const SearchKeeper& keep, SearchFile* file);

}  // namespace oncard::explore
