// A program as a transition system of steps: the same as Model, with remembered steps
// (thread_states.h), which makes a step several times as fast. It has limits: Begin() and Step()
// fail where Model must be used instead.
//
// Deterministic; not thread-safe. Tested by tests/explore/thread_states_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "explore/models/model.h"
#include "explore/models/number_table.h"
#include "explore/models/thread_states.h"

namespace oncard::explore {

class StepModel {
 public:
  static constexpr uint32_t kNone = ~uint32_t{0};

  /// From the current state of a model whose accesses are local (Model::AccessesAreLocal()). A run
  /// from there has fewer statements than `statements`.
  StepModel(const Model& model, int64_t statements)
      : statement_limit_(statements),
        known_(model, statements),
        globals_(known_.globals()),
        now_(static_cast<size_t>(model.thread_count()), kNone),
        end_(known_.model()) {}

  /// Executes every thread up to its first statement that accesses globals. False if that is not
  /// possible.
  bool Begin();

  int thread_count() const { return static_cast<int>(now_.size()); }
  /// Bit n: thread n can execute a step.
  uint32_t runnable() const { return runnable_; }
  /// What the next step of a thread that runs accesses (ThreadStates::AccessOf()).
  uint8_t NextAccess(int thread) const { return known_.AccessOf(now_[Index(thread)]); }
  /// Number of accesses that are known; it can grow with every step.
  size_t access_count() const { return known_.access_count(); }
  uint64_t Dependent(uint8_t access) const { return known_.dependent(access); }
  /// Executes the next step of a thread that runs. False, without a change: ThreadStates does not
  /// know it, or the run would have too many statements.
  bool Step(int thread) {
    const uint32_t state = now_[Index(thread)];
    const ThreadStates::Step* step = known_.StepOf(state, globals_);
    if (step == nullptr || statements_ + step->statements >= statement_limit_) return false;
    Taken taken = {0, step->cell, state, step->statements, static_cast<uint8_t>(thread)};
    if (step->cell != AccessSet::kNone) {
      taken.value = globals_[step->cell];
      globals_[step->cell] = step->value;
    }
    path_.push_back(taken);
    statements_ += step->statements;
    now_[Index(thread)] = step->next;
    if (!known_.Runs(step->next)) runnable_ &= ~(1u << thread);
    return true;
  }
  /// True if the thread runs, and its next step has this access and changes nothing.
  bool Repeats(int thread, uint8_t access) {
    const uint32_t state = now_[Index(thread)];
    if (!known_.Runs(state) || known_.AccessOf(state) != access) return false;
    const ThreadStates::Step* next = known_.StepOf(state, globals_);
    return next != nullptr && next->next == state && next->cell == AccessSet::kNone;
  }
  /// Undoes the last step.
  void Undo() {
    const Taken& taken = path_.back();
    if (taken.cell != AccessSet::kNone) globals_[taken.cell] = taken.value;
    now_[taken.thread] = taken.state;
    runnable_ |= 1u << taken.thread;
    statements_ -= taken.statements;
    path_.pop_back();
  }
  /// Number of steps since Begin().
  size_t depth() const { return path_.size(); }

  /// Number of statements executed, with those before the steps.
  int64_t statements() const { return statements_; }
  /// The thread of every statement since the creation of this model.
  std::vector<uint8_t> StatementThreads() const;
  /// A number of the current state: equal ones belong to equal states. kNone if there are too many.
  uint32_t StateNumber();
  /// The state of a thread; different threads have different ones.
  uint32_t ThreadState(int thread) const { return now_[Index(thread)]; }
  /// As StateNumber(), where states of threads with the same name are the same: `names` has those
  /// of the current ones. Only one of both is to be called.
  uint32_t StateNumber(const std::vector<uint32_t>& names);
  /// The current state as a model, whose steps must not be undone; valid until the next call.
  const Model& AsModel() {
    known_.Load(now_, globals_, &end_);
    return end_;
  }

 private:
  /// Maximum number of different states that get numbers.
  static constexpr size_t kNumberMax = size_t{1} << 20;

  static size_t Index(int thread) { return static_cast<size_t>(thread); }

  uint32_t NumberWithGlobals();

  /// A step that was executed.
  struct Taken {
    int64_t value = 0;   ///< of the cell before it
    uint32_t cell = 0;   ///< that it wrote
    uint32_t state = 0;  ///< of its thread before it
    uint32_t statements = 0;
    uint8_t thread = 0;
  };

  int64_t statement_limit_;
  int64_t statements_ = 0;
  ThreadStates known_;
  std::vector<int64_t> globals_;
  std::vector<uint32_t> now_;  ///< the state of each thread
  uint32_t runnable_ = 0;
  std::vector<uint32_t> begun_;  ///< for each thread, the number of statements of Begin()
  std::vector<Taken> path_;
  Model end_;
  TupleTable numbers_{kNumberMax};  ///< of the states of the threads and the values of the globals
  std::vector<int64_t> state_;
};

}  // namespace oncard::explore
