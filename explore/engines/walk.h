// Runs of a program, alone or with its card, one statement after the other: what samplers, the
// search by preemptions and shrinking walk through without knowing which of the two it is.
//
// A walk knows its way: it finds faults that no single state shows, a race, or a run that has ended
// without what must eventually hold. Not thread-safe. Tested by tests/explore/walk_test.cc.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "explore/models/card_model.h"
#include "explore/models/ends.h"
#include "explore/models/problem.h"
#include "explore/models/races.h"

namespace oncard::explore {

/// A program of variables. The problem outlives the walk.
class ProgramWalk {
 public:
  explicit ProgramWalk(const Problem& problem);

  int thread_count() const { return model_.thread_count(); }
  /// Bit n: thread n of the model can take the next statement.
  uint32_t choices() const { return model_.runnable(); }
  bool ended() const { return choices() == 0; }
  /// It has ended because no thread runs any more.
  bool finished() const { return ended(); }
  /// What is wrong here, or went wrong on the way.
  const Fault& fault() const { return marks_.back().fault; }

  void Step(int thread);
  void Undo();
  /// Back to the start.
  void Restart();

  /// Names the state and what of the way matters to the future.
  StateKey Key() const;
  /// Names the final values of an ended run.
  StateKey EndKey() const { return model_.FinalKey(); }
  /// The values as they are now.
  End EndNow() const { return EndOf(model_); }
  /// Nothing is asked of results: the different ones are to be shown.
  bool asks_nothing() const { return problem_.requirements.empty(); }
  /// Whether the next statements of two threads touch a common variable and one writes it.
  bool DependOnEachOther(int a, int b) const {
    return model_.NextAccess(a).DependsOn(model_.NextAccess(b));
  }

 private:
  struct Mark {
    Fault fault;
    uint32_t reached = 0;  ///< bit n: the n-th kEventually has held in some state
  };

  /// What the present state adds to what was known before it.
  Mark Judge(const Mark& before, const Race& race) const;

  const Problem& problem_;
  Model model_;
  std::vector<Mark> marks_;              ///< one more than statements
  std::vector<RaceDetector> detectors_;  ///< the same, when races are looked for
};

/// A program with its card.
class CardWalk {
 public:
  /// Without its way, which takes much memory and time, it can neither Undo() nor tell its Key(),
  /// and nothing else may use the model while it lives.
  CardWalk(CardModel* model, bool keeps_way) : model_(*model), keeps_way_(keeps_way) { Restart(); }

  int thread_count() const { return model_.thread_count(); }
  uint32_t choices() const { return now().choices; }
  bool ended() const { return now().ended; }
  bool finished() const { return now().finished; }
  const Fault& fault() const { return now().fault; }

  void Step(int thread) {
    if (keeps_way_) {
      states_.push_back(model_.Step(now(), thread));
    } else {
      model_.Advance(&states_.back(), thread);
    }
  }
  /// Without its way: up to `most` statements of the thread, as CardModel::AdvanceAlone().
  int64_t StepAlone(int thread, int64_t most) {
    return model_.AdvanceAlone(&states_.back(), thread, most);
  }
  /// Without its way: the present state, for CardModel::Load().
  CardModel::State WholeState() { return model_.Whole(now()); }
  void Undo() { states_.pop_back(); }
  void Restart() {
    if (!keeps_way_) {
      states_.assign(1, model_.Begin());
    } else if (states_.empty()) {
      states_.push_back(model_.Start());
    } else {
      states_.resize(1);
    }
  }

  StateKey Key() const { return model_.KeyOf(now()); }
  StateKey EndKey() { return model_.FinalKey(WithVariables()); }
  End EndNow() { return EndOf(model_, WithVariables()); }
  bool asks_nothing() const { return model_.asks_nothing(); }
  bool DependOnEachOther(int a, int b) {
    if (keeps_way_) model_.Load(now());
    return model_.NextDependOnEachOther(a, b);
  }

 private:
  const CardModel::State& now() const { return states_.back(); }
  const CardModel::State& WithVariables() {
    if (!keeps_way_) model_.CopyVariables(&states_.back());
    return now();
  }

  CardModel& model_;
  bool keeps_way_;
  std::vector<CardModel::State> states_;  ///< the present one is the last
};

}  // namespace oncard::explore
