// A search, or a part of one, as a file: what is still to be done and what came of the rest. An
// interrupted search goes on from its file; parts of a search that were done elsewhere, at the same
// time, are put together from theirs.
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
  std::string input;          ///< the scenario or source that is explored, as seen from the file
  uint64_t problem = 0;       ///< HashOf(Problem)
  std::string races = "any";  ///< which are wrong, as in a scenario
  EngineKind engine = EngineKind::kDpor;
  int parts = 1;          ///< of the whole search
  std::vector<int> held;  ///< numbers of the parts that the file holds, in order
  TraceSearch traces;     ///< kDpor
  // Of the engines that try random schedules.
  uint64_t seed = 0;
  int depth = SampleOptions{}.depth;
  int64_t runs = 0;      ///< of the whole search
  int64_t runs_cut = 0;  ///< that its part should have made and did not
  SampleCounts samples;

  bool done() const;   ///< of its parts nothing is left to be done
  bool whole() const;  ///< it holds all parts
};

/// Names a problem: its program, where it starts, what must hold.
uint64_t HashOf(const Problem& problem);

/// What is to be done for a part. A part of a search of traces has every so-many-th unit, the same
/// ones whoever asks.
TraceSearch TracesOfPart(const Problem& problem, const SearchPart& part);
/// Its first run and how many it has.
std::pair<int64_t, int64_t> RunsOfPart(int64_t runs, const SearchPart& part);

/// The text of a search file; ends in a newline.
std::string FormatSearchFile(const SearchFile& file);
/// Reads it back. Fails when it is none, or not as it was written, and names the first value that
/// is not what it should be. What it says of the program is for CheckSearch() (search_check.h).
Result<SearchFile> ParseSearchFile(std::string_view text);

/// Adds the parts of another file. Fails, saying why, when the two are not parts of one search,
/// have a part in common, or random runs of one are not all done.
Result<void> MergeInto(SearchFile* file, const SearchFile& other);

/// What the parts have found: a failure, a proof when all are there and done, or what is missing.
/// `known` is a failure that has been shown already.
Exploration Conclude(const Problem& problem, const SearchFile& file,
                     std::optional<Failure> known = {});

}  // namespace oncard::explore
