// Runs of a program, alone or with its card, one statement after the other: the common interface
// for samplers, the search by preemptions and shrinking.
//
// A walk remembers its path, so that it also finds faults that are not visible in a single state: a
// race, a run that ended without a state in which an `eventually` requirement held, or one that
// still owed the right side of a response. Not thread-safe. Tested by tests/explore/walk_test.cc.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "explore/models/card_model.h"
#include "explore/models/ends.h"
#include "explore/models/problem.h"
#include "explore/models/races.h"

namespace oncard::explore {

/// A program without GT commands. The problem must outlive the walk.
class ProgramWalk {
 public:
  /// `coverage` notes the statements, if it is given, and must outlive the walk, too.
  explicit ProgramWalk(const Problem& problem, StatementCoverage* coverage = nullptr);

  int thread_count() const { return model_.thread_count(); }
  /// Bit n: thread n of the model can execute the next statement.
  uint32_t choices() const { return model_.runnable(); }
  bool ended() const { return choices() == 0; }
  /// True if the run ended because no thread runs any more.
  bool finished() const { return ended(); }
  /// The fault of the current state, or of an earlier one.
  const Fault& fault() const { return marks_.back().fault; }

  void Step(int thread);
  void Undo();
  /// Back to the start.
  void Restart();

  /// A key of the state and of the part of the path that matters to the future.
  StateKey Key() const;
  /// A key of the final values of a run that has ended.
  StateKey EndKey() const { return model_.FinalKey(); }
  /// The current values.
  End EndNow() const { return EndOf(model_); }
  /// The program in its current state.
  const Model& model() const { return model_; }
  /// True if there are no requirements on results: the different ones are to be shown.
  bool asks_nothing() const { return problem_.requirements.empty(); }
  /// Whether the next statements of two threads access a common variable and one writes it.
  bool DependOnEachOther(int a, int b) const {
    return model_.NextAccess(a).DependsOn(model_.NextAccess(b));
  }

 private:
  struct Mark {
    Fault fault;
    uint32_t reached = 0;  ///< bit n: the n-th kEventually has held
    uint32_t owed = 0;     ///< bit n: the right side of the n-th kLeads must still come
  };

  /// Updates the data of the path with the current state.
  Mark Judge(const Mark& before, const Race& race) const;

  const Problem& problem_;
  Model model_;
  std::vector<Mark> marks_;              ///< one element more than statements
  std::vector<RaceDetector> detectors_;  ///< the same, if races are searched for
};

/// A program with its card.
class CardWalk {
 public:
  /// Without the path, which takes much memory and time, it supports neither Undo() nor Key(), and
  /// nothing else may use the model during its lifetime.
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
  /// Without the path: up to `most` statements of the thread, as CardModel::AdvanceAlone().
  int64_t StepAlone(int thread, int64_t most) {
    return model_.AdvanceAlone(&states_.back(), thread, most);
  }
  /// Without the path: the current state, for CardModel::Load().
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
  std::vector<CardModel::State> states_;  ///< the current one is the last
};

}  // namespace oncard::explore
