#include "explore/shrink.h"

#include <bit>
#include <cstddef>

namespace oncard::explore {
namespace {

/// Steps in a row of one thread.
struct Turn {
  uint8_t thread = 0;
  int64_t steps = 0;
};

std::vector<Turn> TurnsOf(const std::vector<uint8_t>& steps) {
  std::vector<Turn> turns;
  for (const uint8_t thread : steps) {
    if (turns.empty() || turns.back().thread != thread) turns.push_back({thread, 0});
    ++turns.back().steps;
  }
  return turns;
}

/// How many steps a schedule goes on after the last turn that it was given.
constexpr int64_t kExtraSteps = 100'000;

/// Follows the turns, then lets the threads run one after the other. The steps up to the first
/// fault; empty when there is none.
std::vector<uint8_t> Follow(const Problem& problem, Model* model, const std::vector<Turn>& turns) {
  const int64_t start = model->depth();
  std::vector<uint8_t> taken;
  bool failed = false;
  const auto take = [&](int thread) {
    model->Step(thread);
    taken.push_back(static_cast<uint8_t>(thread));
    failed = static_cast<bool>(FindFault(problem, *model));
  };
  for (const Turn& turn : turns) {
    for (int64_t i = 0; i < turn.steps && !failed && model->Running(turn.thread); ++i) {
      take(turn.thread);
    }
  }
  int thread = taken.empty() ? 0 : taken.back();
  for (int64_t i = 0; i < kExtraSteps && !failed && model->runnable() != 0; ++i) {
    if (!model->Running(thread)) thread = std::countr_zero(model->runnable());
    take(thread);
  }
  while (model->depth() > start) model->Undo();
  if (!failed) taken.clear();
  return taken;
}

/// The turns with turn `index` joined to the next turn of its thread; false when it has none.
bool JoinWithNext(const std::vector<Turn>& turns, size_t index, std::vector<Turn>* joined) {
  for (size_t next = index + 2; next < turns.size(); ++next) {
    if (turns[next].thread != turns[index].thread) continue;
    *joined = turns;
    (*joined)[index].steps += turns[next].steps;
    joined->erase(joined->begin() + static_cast<std::ptrdiff_t>(next));
    return true;
  }
  return false;
}

}  // namespace

int CountPreemptions(Model* model, const std::vector<uint8_t>& steps) {
  const int64_t start = model->depth();
  int preemptions = 0;
  for (size_t i = 0; i < steps.size(); ++i) {
    if (i > 0 && steps[i] != steps[i - 1] && model->Running(steps[i - 1])) ++preemptions;
    model->Step(steps[i]);
  }
  while (model->depth() > start) model->Undo();
  return preemptions;
}

std::vector<uint8_t> Shrink(const Problem& problem, const std::vector<uint8_t>& steps) {
  Model model = problem.model;
  model.TrackKey(false);
  std::vector<uint8_t> best = steps;
  int fewest = CountPreemptions(&model, best);
  bool better = true;
  while (better && fewest > 0) {
    better = false;
    const std::vector<Turn> turns = TurnsOf(best);
    std::vector<Turn> joined;
    for (size_t i = 0; i < turns.size() && !better; ++i) {
      if (!JoinWithNext(turns, i, &joined)) continue;
      const std::vector<uint8_t> tried = Follow(problem, &model, joined);
      if (tried.empty()) continue;
      const int preemptions = CountPreemptions(&model, tried);
      if (preemptions > fewest || (preemptions == fewest && tried.size() >= best.size())) continue;
      best = tried;
      fewest = preemptions;
      better = true;
    }
  }
  return best;
}

}  // namespace oncard::explore
