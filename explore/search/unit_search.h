// A search in units, which are searched one after the other, each in one go: the cases of a
// scenario's choices and, with a card, groups of schedules of each case
// (explore/engines/card_cut.h). What the units have shown is added up, so that a search can be
// ended after any unit, continued and divided. Plain values. Tested by
// tests/explore/unit_search_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "explore/search/case_counts.h"
#include "explore/search/explorer.h"
#include "explore/search/search_json.h"
#include "runtime/observe/supervisor.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/sim/refused_commands.h"

namespace oncard::explore {

/// What a search has found in places of the program, and has not put to the test.
struct Remarks {
  std::vector<runtime::RefusedCommand> refused;
  std::vector<runtime::CardFinding> card;
  UntestedInAll untested;

  bool empty() const {
    return refused.empty() && card.empty() && untested.fewest == UntestedInAll::kNone;
  }
};

struct UnitSearch {
  static constexpr int kGroupsMax = 100'000;  ///< as many as there can be parts

  int64_t cases = 1;  ///< of the scenario's choices
  int groups = 1;     ///< of the schedules of each case
  /// Units that are still to be searched, in order: unit case * groups + group, both from 0.
  std::vector<int64_t> left;
  // Options of the search.
  bool all = false;  ///< it goes on after a failure
  bool islands = true;
  bool reductions = true;
  std::optional<bool> merge_private;
  int preemptions = BoundedOptions{}.preemptions;
  // What the others have shown:
  std::optional<int64_t> failing;    ///< the first one that fails
  std::optional<Exploration> found;  ///< the counts, ends and horizon; not the failure

  int64_t units() const { return cases * groups; }
  /// What must be the same in all parts of a search.
  auto Kind() const {
    return std::tuple(cases, groups, all, islands, reductions, merge_private, preemptions);
  }
};

/// How many groups the schedules of each case are divided into, for a search in so many parts: one
/// where the cases alone are enough to be divided.
int GroupsFor(int64_t cases, int parts);

/// The units of a part: every `parts`-th one.
std::vector<int64_t> UnitsOfPart(int64_t units, int number, int parts);

/// Adds what other units of the same search have shown, and those that they have left.
void MergeInto(UnitSearch* units, const UnitSearch& others);
void MergeInto(Remarks* remarks, const Remarks& others);

/// Write them as values of a search file, and read them back. Fails as SearchReader if a value is
/// not of its type, or if a unit is not one of the parts `held` of `parts`.
void PutUnits(const UnitSearch& units, SearchWriter* writer);
UnitSearch UnitsFrom(SearchReader& reader, const SearchValue& value, const std::vector<int>& held,
                     int parts);
void PutRemarks(const Remarks& remarks, SearchWriter* writer);
Remarks RemarksFrom(SearchReader& reader, const SearchValue& value);

}  // namespace oncard::explore
