#include "explore/engines/waiting_loop.h"

#include <algorithm>
#include <bit>

#include "explore/engines/state_graph.h"

namespace oncard::explore {
namespace {

/// The number of statements of a pass with which the thread waits; 0 if it does not.
int64_t PassOf(Model* model, int thread) {
  const AccessSet access = model->NextAccess(thread);
  if (access.empty() || access.write != AccessSet::kNone) return 0;
  const auto cells = model->ThreadCells(thread);
  const std::vector<int64_t> before(cells.begin(), cells.end());
  model->Step(thread);
  const int64_t statements = 1 + model->StepPrivate(thread, kMergedMax);
  const bool same = std::ranges::equal(before, model->ThreadCells(thread));
  for (int64_t i = 0; i < statements; ++i) model->Undo();
  return same ? statements : 0;
}

}  // namespace

bool WaitsInLoop(Model* model, int thread) { return PassOf(model, thread) > 0; }

std::vector<uint8_t> EndlessWait(Model model) {
  std::vector<uint8_t> passes;
  for (uint32_t left = model.runnable(); left != 0; left &= left - 1) {
    const int thread = std::countr_zero(left);
    const int64_t statements = PassOf(&model, thread);
    if (statements == 0) return {};
    passes.insert(passes.end(), static_cast<size_t>(statements), static_cast<uint8_t>(thread));
  }
  return passes;
}

}  // namespace oncard::explore
