// A search, or a part of one, as a file: the remaining work and the results so far. An interrupted
// search is continued from its file; parts of a search that ran on several computers are merged
// from their files.
//
// The text form is JSON and described in docs/search-format.md. Tested by
// tests/explore/search_file_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "explore/search/explorer.h"
#include "explore/search/unit_search.h"

namespace oncard::explore {

/// One of `count` parts of a search, from 1.
struct SearchPart {
  int number = 1;
  int count = 1;
  bool operator==(const SearchPart&) const = default;
};
inline constexpr int kPartMax = 100'000;

/// Reads `3/8`.
Result<SearchPart> ParsePart(std::string_view text);

struct SearchFile {
  std::string input;          ///< path of the explored scenario or source, relative to the file
  uint64_t problem = 0;       ///< HashOf(Problem)
  std::string races = "any";  ///< which races are failures, as in a scenario
  EngineKind engine = EngineKind::kDpor;
  int parts = 1;          ///< of the whole search
  std::vector<int> held;  ///< numbers of the parts that the file holds, in order
  /// With a card, or choices, unless the schedules are random: the work and what it has shown.
  std::optional<UnitSearch> units;
  Remarks remarks;     ///< with a card, or choices
  TraceSearch traces;  ///< otherwise kDpor
  // For the engines with random schedules.
  uint64_t seed = 0;
  int depth = SampleOptions{}.depth;
  int64_t runs = 0;      ///< of the whole search
  int64_t runs_cut = 0;  ///< runs of the part that were not made
  SampleCounts samples;
  int64_t failing_case = 0;  ///< of the choices: that of SampleCounts::failing

  bool failed() const;  ///< a failure was found
  bool done() const;    ///< nothing is left to be done for its parts
  bool whole() const;   ///< it holds all parts
};

/// A hash of a problem: its program, its initial state and what is asked of its runs.
uint64_t HashOf(const Problem& problem);

/// The work of a part. A part I/N of a search of traces has every N-th unit, always the same ones.
TraceSearch TracesOfPart(const Problem& problem, const SearchPart& part);
/// The number of its first run, and its number of runs.
std::pair<int64_t, int64_t> RunsOfPart(int64_t runs, const SearchPart& part);

/// Makes a new search one of random runs.
void BeginRuns(const ExploreOptions& options, const SearchPart& part, SearchFile* file);
/// The options with those that the file contains.
ExploreOptions WithOptionsOf(const SearchFile& file, ExploreOptions options);

/// Adds random runs, of which those that fail are of one case of the choices.
void AddSamples(SampleCounts more, int64_t failing_case, SearchFile* file);

/// The parts that the file does not hold: `2, 3`.
std::string MissingParts(const SearchFile& file);

/// Why a search that has found no failure has no proof: of its parts some are missing, or not
/// complete.
Message WhyNotProved(const SearchFile& file);

/// The text of a search file; ends in a newline.
std::string FormatSearchFile(const SearchFile& file);
/// Reads it back. Fails with the first invalid value if it is not a search file, or if it has been
/// modified. Its statements about the program are checked by CheckSearch() (search_check.h).
Result<SearchFile> ParseSearchFile(std::string_view text);

/// Adds the parts of another file. Fails with the reason if the two are not parts of one search,
/// have a part in common, or have random runs that are not finished.
Result<void> MergeInto(SearchFile* file, const SearchFile& other);

/// The result of the parts: a failure, a proof if all are present and complete, or what is missing.
/// `known` is a failure that has been prepared already.
Exploration Conclude(const Problem& problem, const SearchFile& file,
                     std::optional<Failure> known = {});

}  // namespace oncard::explore
