#include "explore/engines/sampler.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/random.h"
#include "explore/engines/found_parts.h"
#include "explore/engines/walk.h"
#include "explore/models/key_set.h"

namespace oncard::explore {
namespace {

template <typename Walk>
class Sampler {
 public:
  Sampler(Walk walk, const SampleOptions& options)
      : walk_(std::move(walk)), options_(options), random_(options.seed) {}

  SampleCounts Run() {
    if (options_.kind == SamplerKind::kPct) length_ = MeasureLength();
    KeySet ends;
    for (; counts_.runs < options_.runs; ++counts_.runs) {
      if (IsTold(options_.stop) || statements_ >= options_.all_statements) break;
      if (options_.until_bad && counts_.bad > 0) break;
      SeedRun(options_.first_run + counts_.runs);
      DrawPriorities();
      if (!RunOnce()) break;
      if (walk_.finished() && ends.Insert(walk_.EndKey()) && walk_.asks_nothing()) {
        counts_.values.Add(walk_.EndNow());
      }
      if (options_.progress != nullptr) {
        options_.progress->executions.store(counts_.runs + 1, std::memory_order_relaxed);
      }
    }
    counts_.seed = options_.seed;
    counts_.ends = ends.Keys();
    std::ranges::sort(counts_.ends);
    return std::move(counts_);
  }

 private:
  void SeedRun(int64_t run) {
    uint64_t state = options_.seed + static_cast<uint64_t>(run) * 0xd1342543de82ef95ULL;
    random_ = NextRandom(state);
  }

  /// The approximate number of statements of a run, for kPct.
  uint64_t MeasureLength() {
    SeedRun(-1);
    DrawPriorities();
    RunOnce();
    const int64_t statements = counts_.longest;
    counts_ = {};
    return static_cast<uint64_t>(std::max<int64_t>(statements, 1));
  }

  /// False, and the run does not count, if the search is told to end.
  bool RunOnce() {
    walk_.Restart();
    steps_.clear();
    bool wrong = static_cast<bool>(walk_.fault());
    while (!wrong && !walk_.ended()) {
      if (IsTold(options_.stop)) return false;
      if (static_cast<int64_t>(steps_.size()) >= options_.statement_limit) {
        ++counts_.cut;
        break;
      }
      const int thread = Choose();
      steps_.push_back(static_cast<uint8_t>(thread));
      walk_.Step(thread);
      wrong = static_cast<bool>(walk_.fault());
    }
    statements_ += static_cast<int64_t>(steps_.size());
    counts_.longest = std::max(counts_.longest, static_cast<int64_t>(steps_.size()));
    if (wrong && counts_.bad++ == 0) counts_.failing = steps_;
    return true;
  }

  void DrawPriorities() {
    for (int64_t& priority : priorities_) priority = Draw();
    changes_.clear();
    if (options_.kind != SamplerKind::kPct) return;
    for (int i = 1; i < options_.depth; ++i) {
      changes_.push_back(static_cast<int64_t>(RandomBelow(random_, length_)));
    }
  }
  /// A priority above all those that change points assign.
  int64_t Draw() { return static_cast<int64_t>(NextRandom(random_) >> 1); }

  int Choose() {
    const uint32_t choices = walk_.choices();
    if (options_.kind == SamplerKind::kRandom) return vm::RandomThread(random_, choices);
    int best = vm::HighestThread(choices, priorities_);
    if (options_.kind == SamplerKind::kPct) {
      for (size_t i = 0; i < changes_.size(); ++i) {
        if (changes_[i] != static_cast<int64_t>(steps_.size())) continue;
        // Below all others; later change points assign still lower ones.
        priorities_[static_cast<size_t>(best)] = -1 - static_cast<int64_t>(i);
        best = vm::HighestThread(choices, priorities_);
      }
      return best;
    }
    for (int other = 0; other < walk_.thread_count(); ++other) {
      if (other == best || (choices >> other & 1) == 0) continue;
      if (walk_.DependOnEachOther(best, other)) priorities_[static_cast<size_t>(other)] = Draw();
    }
    priorities_[static_cast<size_t>(best)] = Draw();
    return best;
  }

  Walk walk_;
  const SampleOptions& options_;
  uint64_t random_;
  uint64_t length_ = 1;  ///< kPct
  SampleCounts counts_;
  int64_t statements_ = 0;  ///< of all runs
  std::vector<uint8_t> steps_;
  std::array<int64_t, kThreadMax> priorities_{};
  std::vector<int64_t>
      changes_;  ///< kPct: indices of the statements before which a priority is lowered
};

}  // namespace

std::pair<int64_t, int64_t> RunsOfShare(int64_t runs, int64_t share, int64_t shares) {
  const int64_t each = runs / shares;
  const int64_t more = runs % shares;
  return {each * share + std::min(share, more), each + (share < more ? 1 : 0)};
}

int64_t ShareOfRun(int64_t run, int64_t runs, int64_t shares) {
  const int64_t each = runs / shares;
  const int64_t more = runs % shares;
  const int64_t longer = more * (each + 1);  // runs of the first shares
  return run < longer ? run / (each + 1) : more + (run - longer) / each;
}

void MergeInto(SampleCounts* samples, const SampleCounts& other) {
  samples->runs += other.runs;
  samples->bad += other.bad;
  samples->cut += other.cut;
  samples->longest = std::max(samples->longest, other.longest);
  samples->ends = UnionOf(samples->ends, other.ends);
  samples->seed = other.seed;
  for (const End& end : other.values.ends()) samples->values.Add(end);
  TakeSimpler(other.failing, &samples->failing);
  samples->coverage.Include(other.coverage);
}

SampleCounts Sample(const Problem& problem, const SampleOptions& options) {
  StatementCoverage coverage;
  SampleCounts counts = Sampler(ProgramWalk(problem, &coverage), options).Run();
  counts.coverage = std::move(coverage);
  return counts;
}

SampleCounts SampleCard(CardModel* model, const SampleOptions& options) {
  return Sampler(CardWalk(model, false), options).Run();
}

}  // namespace oncard::explore
