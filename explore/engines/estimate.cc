#include "explore/engines/estimate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "explore/engines/progress.h"

namespace oncard::explore {
namespace {

struct Sleeper {
  int thread = 0;
  AccessSet access;
};

/// Follows a random execution with sleep sets and returns the product of the numbers of choices in
/// its states. The expectation of the product is the number of complete executions, one per trace.
/// 0 if the sleep sets cut the execution off; negative if it does not end.
double Descend(Model* model, uint64_t* random, int64_t depth) {
  const int64_t start = model->depth();
  double ways = 1;
  std::vector<Sleeper> sleep;
  while (model->runnable() != 0 && ways > 0) {
    if (model->depth() - start >= depth) ways = -1;
    uint32_t awake = model->runnable();
    for (const Sleeper& sleeper : sleep) awake &= ~(1u << sleeper.thread);
    if (awake == 0 || ways < 0) {
      ways = std::min(ways, 0.0);
      break;
    }
    // A statement that accesses nothing shared is not a choice.
    uint32_t left = awake;
    for (uint32_t all = awake; all != 0; all &= all - 1) {
      if (model->NextAccess(std::countr_zero(all)).empty()) left = all & ~(all - 1);
    }
    const int count = std::popcount(left);
    ways *= count;
    for (uint64_t skip = RandomBelow(*random, static_cast<uint64_t>(count)); skip > 0; --skip) {
      const int earlier = std::countr_zero(left);
      sleep.push_back({earlier, model->NextAccess(earlier)});
      left &= left - 1;
    }
    const int thread = std::countr_zero(left);
    const AccessSet access = model->NextAccess(thread);
    std::erase_if(sleep, [&](const Sleeper& sleeper) { return sleeper.access.DependsOn(access); });
    model->Step(thread);
  }
  while (model->depth() > start) model->Undo();
  return ways;
}

}  // namespace

TraceEstimate EstimateTraces(Model* model, int descents, uint64_t seed, int64_t depth,
                             const std::atomic<bool>* stop) {
  uint64_t random = seed;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < descents; ++i) {
    const double ways = Descend(model, &random, depth);
    if (ways < 0 || IsTold(stop)) return {};
    sum += ways;
    squares += ways * ways;
  }
  const double mean = sum / descents;
  const double variance = std::max(0.0, squares / descents - mean * mean);
  return {mean, std::sqrt(variance / descents)};
}

}  // namespace oncard::explore
