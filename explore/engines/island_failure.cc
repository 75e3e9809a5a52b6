#include "explore/engines/island_failure.h"

#include <bit>
#include <utility>

#include "explore/engines/progress.h"

namespace oncard::explore {
namespace {

/// A longer schedule is not tried to its end.
constexpr size_t kStepsMax = 1'000'000;

class Replay {
 public:
  Replay(CardModel* whole, uint32_t threads, const std::atomic<bool>* stop)
      : whole_(*whole), threads_(threads), stop_(stop), state_(whole->Start()) {}

  bool over() const {
    return state_.fault || state_.ended || steps_.size() >= kStepsMax || IsTold(stop_);
  }
  bool failed() const { return static_cast<bool>(state_.fault); }
  std::vector<uint8_t> TakeSteps() { return std::move(steps_); }

  /// Others run until a cycle begins. False if they cannot, or it is over.
  bool Reach(int64_t cycle) {
    while (!over() && CardModel::CycleOf(state_) < cycle && StepOther()) {
    }
    return !over() && CardModel::CycleOf(state_) == cycle;
  }

  /// A thread of the island executes a statement in this cycle, after those of the others that must
  /// be served before. False if it cannot, or it is over.
  bool StepInside(int thread, int64_t cycle) {
    while (!over() && (state_.choices >> thread & 1) == 0 && StepOther()) {
    }
    if (over() || CardModel::CycleOf(state_) != cycle) return false;
    if ((state_.choices >> thread & 1) == 0) return false;
    Step(thread);
    return true;
  }

  /// The run goes on to its end.
  void End() {
    while (!over()) {
      if (!StepOther()) Step(std::countr_zero(state_.choices));
    }
  }

 private:
  bool StepOther() {
    const uint32_t others = state_.choices & ~threads_;
    if (others != 0) Step(std::countr_zero(others));
    return others != 0;
  }

  void Step(int thread) {
    state_ = whole_.Step(state_, thread);
    steps_.push_back(static_cast<uint8_t>(thread));
  }

  CardModel& whole_;
  uint32_t threads_;
  const std::atomic<bool>* stop_;
  CardModel::State state_;
  std::vector<uint8_t> steps_;
};

}  // namespace

std::vector<uint8_t> FailInWhole(CardModel* whole, CardModel* island, uint32_t threads,
                                 const std::vector<uint8_t>& way, const std::atomic<bool>* stop) {
  std::vector<int> members;
  for (uint32_t left = threads; left != 0; left &= left - 1) {
    members.push_back(std::countr_zero(left));
  }
  Replay replay(whole, threads, stop);
  CardModel::State inside = island->Start();
  for (const uint8_t choice : way) {
    if (choice == kOthersEndCycle) {
      inside = island->EndCycle(inside);
      continue;
    }
    const int64_t cycle = CardModel::CycleOf(inside);
    if (!replay.Reach(cycle) || !replay.StepInside(members[choice], cycle)) break;
    inside = island->Step(inside, choice);
  }
  replay.End();
  return replay.failed() ? replay.TakeSteps() : std::vector<uint8_t>{};
}

}  // namespace oncard::explore
