// Tries random schedules, for programs that are too large to be explored completely.
//
//   random  every statement of a thread drawn uniformly from those that can run
//   pct     probabilistic concurrency testing (Burckhardt et al., ASPLOS 2010): threads run by
//           random priorities, which change at depth - 1 random statements; finds a fault that
//           needs `depth` orderings with a known probability
//   pos     partial order sampling (Yuan, Yang, Gu, CAV 2018): every statement has a random
//           priority, which is drawn again when a dependent statement is executed before it;
//           only for programs without GT commands
//
// Reproducible: the same seed gives the same runs everywhere. Tested by
// tests/explore/sampler_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "explore/engines/progress.h"
#include "explore/models/card_model.h"
#include "explore/models/ends.h"
#include "explore/models/problem.h"
#include "explore/models/state_key.h"
#include "explore/models/statement_coverage.h"
#include "vm/thread_choice.h"

namespace oncard::explore {

enum class SamplerKind : uint8_t { kRandom, kPct, kPos };

using vm::kPctDepthMax;

struct SampleOptions {
  SamplerKind kind = SamplerKind::kRandom;
  int64_t runs = 10'000;
  /// Number of the first run: each run has random numbers of its own, so that the runs can be
  /// divided among several computers.
  int64_t first_run = 0;
  uint64_t seed = 1;
  int depth = 3;  ///< kPct: 1..kPctDepthMax
  /// Maximum number of statements of one run; a longer run is abandoned.
  int64_t statement_limit = 100'000;
  int64_t all_statements =
      INT64_MAX;           ///< no run begins after this number of statements of all runs
  bool until_bad = false;  ///< stop after the first failing run
  const std::atomic<bool>* stop = nullptr;
  SearchProgress* progress = nullptr;
};

struct SampleCounts {
  int64_t runs = 0;
  int64_t bad = 0;
  int64_t cut = 0;      ///< abandoned runs
  int64_t longest = 0;  ///< statements
  uint64_t seed = 0;
  std::vector<StateKey>
      ends;       ///< sorted keys of different ends: globals and return values of the threads
  EndSet values;  ///< of some of them, if there are no requirements on results
  /// The threads of the first failing run, as numbered by the model.
  std::vector<uint8_t> failing;
  StatementCoverage coverage = {};  ///< without a card (CardModel::coverage())
};

/// Of runs that are divided into shares, the first of which have one more: the number of the first
/// run of a share, from 0, and its number of runs; and the share of a run.
std::pair<int64_t, int64_t> RunsOfShare(int64_t runs, int64_t share, int64_t shares);
int64_t ShareOfRun(int64_t run, int64_t runs, int64_t shares);

/// Adds the results of other runs of the same sampler.
void MergeInto(SampleCounts* samples, const SampleCounts& other);

SampleCounts Sample(const Problem& problem, const SampleOptions& options);
/// The same with a card.
SampleCounts SampleCard(CardModel* model, const SampleOptions& options);

}  // namespace oncard::explore
