#include "explore/engines/shrink.h"

#include <bit>
#include <cstddef>
#include <utility>

#include "explore/engines/progress.h"
#include "explore/engines/waiting_loop.h"
#include "explore/engines/walk.h"

namespace oncard::explore {
namespace {

/// Consecutive steps of one thread.
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

/// The turns with turn `index` joined to the next turn of its thread; false if there is none.
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

/// Maximum number of steps after the last given turn, and how many consecutive ones a thread may
/// take: a thread that waits in a loop must let the others continue.
constexpr int64_t kExtraSteps = 100'000;
constexpr int64_t kExtraTurn = 1000;
/// Maximum number of statements executed to find a simpler schedule.
constexpr int64_t kProgramEffort = 5'000'000;

/// A schedule that leads to a fault.
struct Way {
  std::vector<uint8_t> steps;
  int preemptions = 0;
  Fault fault;

  bool SimplerThan(const Way& other) const {
    return std::pair(preemptions, steps.size()) < std::pair(other.preemptions, other.steps.size());
  }
};

template <typename Walk>
class Shrinker {
 public:
  Shrinker(Walk walk, int64_t effort, const std::atomic<bool>* hurried)
      : walk_(std::move(walk)), effort_(effort), hurried_(hurried) {}

  Failure Run(const std::vector<uint8_t>& steps) {
    Way best = Follow(TurnsOf(steps));
    tries_ = true;
    while (effort_ > 0 && Improve(&best)) {
    }
    return FailureOf(std::move(best));
  }

  Failure Take(const std::vector<uint8_t>& steps) { return FailureOf(Follow(TurnsOf(steps))); }
  /// True if the last run was executed to its end.
  bool ended() const { return ended_; }

 private:
  static Failure FailureOf(Way way) {
    Failure failure;
    failure.steps = std::move(way.steps);
    failure.preemptions = way.preemptions;
    failure.fault = way.fault;
    return failure;
  }

  /// Executes the turns, then the threads one after the other, up to the first fault.
  Way Follow(const std::vector<Turn>& turns) {
    walk_.Restart();
    Way way;
    int last = -1;
    const auto take = [&](int thread) {
      if (last >= 0 && thread != last && (walk_.choices() >> last & 1) != 0) ++way.preemptions;
      walk_.Step(thread);
      way.steps.push_back(static_cast<uint8_t>(thread));
      last = thread;
      --effort_;
    };
    const auto going = [&] { return !walk_.fault() && !walk_.ended() && !GivesUp(); };
    for (const Turn& turn : turns) {
      for (int64_t i = 0; i < turn.steps && going(); ++i) {
        if ((walk_.choices() >> turn.thread & 1) == 0) break;
        take(turn.thread);
      }
    }
    for (int64_t i = 0, turn = 0; i < kExtraSteps && going(); ++i) {
      const uint32_t choices = walk_.choices();
      const bool can_go_on = last >= 0 && (choices >> last & 1) != 0;
      if (!can_go_on || turn == kExtraTurn) {
        turn = 0;
        const uint32_t behind = last < 0 ? choices : choices & (~uint32_t{1} << last);
        take(std::countr_zero(behind != 0 ? behind : choices));
      } else {
        take(last);
      }
      ++turn;
    }
    way.fault = walk_.fault();
    ended_ = walk_.ended();
    return way;
  }

  /// A schedule that is only tried need not be followed to its end.
  bool GivesUp() const { return tries_ && IsTold(hurried_); }

  /// Replaces the schedule by the first simpler one, if there is any.
  bool Improve(Way* best) {
    const std::vector<Turn> turns = TurnsOf(best->steps);
    for (size_t i = 0; i < turns.size() && effort_ > 0 && !GivesUp(); ++i) {
      std::vector<Turn> joined;
      if (JoinWithNext(turns, i, &joined) && Try(joined, best)) return true;
      std::vector<Turn> without = turns;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      if (Try(without, best)) return true;
      std::vector<Turn> shorter = turns;
      shorter[i].steps /= 2;
      if (shorter[i].steps > 0 && Try(shorter, best)) return true;
    }
    return false;
  }

  bool Try(const std::vector<Turn>& turns, Way* best) {
    Way way = Follow(turns);
    if (!way.fault || !way.SimplerThan(*best)) return false;
    *best = std::move(way);
    return true;
  }

  Walk walk_;
  int64_t effort_;
  const std::atomic<bool>* hurried_;
  bool tries_ = false;  ///< the given schedule has been followed
  bool ended_ = false;
};

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

void TakeRacingStatements(const Problem& problem, Failure* failure) {
  if (failure->fault.kind != Fault::Kind::kRace) return;
  Model model = problem.model;
  for (const uint8_t thread : failure->steps) model.Step(thread);
  for (const RacingStatement& racing : {failure->fault.race.first, failure->fault.race.second}) {
    if (!model.Running(racing.thread) || model.Position(racing.thread) != racing.position) continue;
    model.Step(racing.thread);
    failure->steps.push_back(static_cast<uint8_t>(racing.thread));
  }
  model = problem.model;
  failure->preemptions = CountPreemptions(&model, failure->steps);
}

Failure Shrink(const Problem& problem, const std::vector<uint8_t>& steps,
               const std::atomic<bool>* hurried) {
  Failure failure = Shrinker(ProgramWalk(problem), kProgramEffort, hurried).Run(steps);
  TakeRacingStatements(problem, &failure);
  return failure;
}

Failure ShrinkExecution(const Problem& problem, const std::vector<uint8_t>& steps,
                        const std::atomic<bool>* hurried) {
  ProgramWalk walk(problem);
  for (const uint8_t thread : steps) {
    walk.Step(thread);
    if (walk.fault()) return Shrink(problem, steps, hurried);
  }
  Failure failure;
  failure.livelock = true;
  failure.steps = steps;
  failure.cycle = EndlessWait(walk.model());
  Model start = problem.model;
  failure.preemptions = CountPreemptions(&start, steps);
  return failure;
}

Failure ShrinkCard(CardModel* model, const std::vector<uint8_t>& steps,
                   const std::atomic<bool>* hurried) {
  return Shrinker(CardWalk(model, false), kCardEffort, hurried).Run(steps);
}

FollowedRun TakeSteps(const Problem& problem, const std::vector<uint8_t>& steps) {
  Shrinker shrinker(ProgramWalk(problem), kProgramEffort, nullptr);
  FollowedRun run = {shrinker.Take(steps), shrinker.ended()};
  TakeRacingStatements(problem, &run.failure);
  return run;
}

FollowedRun TakeCardSteps(CardModel* model, const std::vector<uint8_t>& steps) {
  Shrinker shrinker(CardWalk(model, false), kCardEffort, nullptr);
  return {shrinker.Take(steps), shrinker.ended()};
}

}  // namespace oncard::explore
