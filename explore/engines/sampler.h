// Tries random schedules, for what is too large to be explored whole.
//
//   random  every statement of a thread drawn uniformly from those that can go on
//   pct     probabilistic concurrency testing (Burckhardt et al., ASPLOS 2010): threads run by
//   random
//           priorities, which change at depth - 1 random statements; finds a fault that needs
//           `depth` orderings with a known probability
//   pos     partial order sampling (Yuan, Yang, Gu, CAV 2018): every statement has a random
//   priority,
//           which is drawn anew when another one that depends on it goes first; programs of
//           variables only
//
// Reproducible: the same seed gives the same runs everywhere. Tested by
// tests/explore/sampler_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "explore/engines/progress.h"
#include "explore/models/card_model.h"
#include "explore/models/ends.h"
#include "explore/models/problem.h"
#include "explore/models/state_key.h"

namespace oncard::explore {

enum class SamplerKind : uint8_t { kRandom, kPct, kPos };

inline constexpr int kPctDepthMax = 64;

struct SampleOptions {
  SamplerKind kind = SamplerKind::kRandom;
  int64_t runs = 10'000;
  /// Number of the first run: each run has random numbers of its own, so that parts of the runs can
  /// be taken elsewhere.
  int64_t first_run = 0;
  uint64_t seed = 1;
  int depth = 3;  ///< kPct: 1..kPctDepthMax
  /// Statements of one run; a longer one is given up.
  int64_t statement_limit = 100'000;
  int64_t all_statements = INT64_MAX;  ///< no run begins after so many of all runs
  bool until_bad = false;              ///< the first run that goes wrong is the last one
  const std::atomic<bool>* stop = nullptr;
  SearchProgress* progress = nullptr;
};

struct SampleCounts {
  int64_t runs = 0;
  int64_t bad = 0;
  int64_t cut = 0;      ///< given up
  int64_t longest = 0;  ///< statements
  uint64_t seed = 0;
  std::vector<StateKey> ends;  ///< different ones, in order: globals and what the threads returned
  EndSet values;               ///< of some of them, where nothing is asked of results
  /// The threads of the first run that went wrong, counted as the model does.
  std::vector<uint8_t> failing;
};

/// Adds what other runs of the same sampler have found.
void MergeInto(SampleCounts* samples, const SampleCounts& other);

SampleCounts Sample(const Problem& problem, const SampleOptions& options);
/// The same with a card.
SampleCounts SampleCard(CardModel* model, const SampleOptions& options);

}  // namespace oncard::explore
