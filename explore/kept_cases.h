// The searches of kept_exploration.h with a card, or in every case of a scenario's choices. What
// they keep are units (search/unit_search.h), or random runs, whose numbers go on from case to
// case. Deterministic. Tested by tests/explore/kept_cases_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "explore/reports/report.h"
#include "explore/search/kept_search.h"
#include "explore/search/search_file.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/file/scenario.h"
#include "vm/object.h"

namespace oncard::explore {

/// What is searched. All must outlive its use.
struct SearchedScenario {
  const runtime::Scenario& scenario;
  const std::vector<runtime::Requirement>& requirements;
  const vm::Object& object;
};

/// True for a program with its card, and where choices are open. Fails as ExploreScenario().
Result<bool> IsKeptByCases(const SearchedScenario& searched);

/// A hash of the program, its initial state and what is asked of its runs in all cases.
Result<uint64_t> HashByCases(const SearchedScenario& searched);

/// A new search of a part; the caller fills in SearchFile::input. Fails as ExploreScenario(), if
/// there are fewer units, or cases for random runs, than the search is to have parts, and where
/// races are allowed that are benign: to know them takes one search.
Result<SearchFile> BeginByCases(const SearchedScenario& searched, const ExploreOptions& options,
                                const SearchPart& part);

/// Checks what a file says of the program: its cases, results and failing run. Fails with
/// what does not fit.
Result<void> CheckByCases(const SearchedScenario& searched, const SearchFile& file);

/// Continues a search until it is complete, fails, a limit is reached or it is interrupted. `keep`
/// is called after each unit, and for random runs when SearchProgress::pausing is set. A unit that
/// is not complete is begun again when the search is continued. Options that the file contains are
/// taken from the file.
Result<Findings> GoOnByCases(const SearchedScenario& searched, const ExploreOptions& options,
                             const SearchKeeper& keep, SearchFile* file);

/// The result of the parts in a file. A unit that fails is searched again, to show how.
Result<Findings> ConcludeByCases(const SearchedScenario& searched, const ExploreOptions& options,
                                 const SearchFile& file);

}  // namespace oncard::explore
