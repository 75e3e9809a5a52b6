// The states that single threads of a program can have, and what the next step of a thread does in
// each of them: a step that was executed once in a model is looked up from then on.
//
// A step is one statement that accesses globals, together with the following statements of its
// thread that do not; or, on request, every statement is a step. What it does is determined by the
// values of its thread's variables and of the globals that it reads. Deterministic; not
// thread-safe. Tested by tests/explore/thread_states_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "explore/models/model.h"
#include "explore/models/number_table.h"

namespace oncard::explore {

class ThreadStates {
 public:
  static constexpr uint32_t kNone = ~uint32_t{0};
  /// Maximum number of different accesses (AccessSet) of a program's steps.
  static constexpr size_t kAccessMax = 64;
  /// Maximum number of states, and of steps: where there are more, the next one is rarely known
  /// already.
  static constexpr size_t kStateMax = size_t{1} << 18;
  /// Instead of a number of statements: every statement is a step.
  static constexpr int64_t kSingleStatements = 0;

  /// A thread's step.
  struct Step {
    int64_t value = 0;                 ///< the value that it writes
    uint32_t cell = AccessSet::kNone;  ///< the global that it writes, if it writes one
    uint32_t next = kNone;             ///< the thread's state afterwards
    uint32_t statements = 0;           ///< number of statements
  };

  /// For the threads of a program. The accesses of its statements must be local
  /// (Model::AccessesAreLocal()). Steps that are several statements also forget what the model
  /// forgets (Model::ForgetDeadLocals()). Runs of statements that access no globals are given up if
  /// they are not shorter than `statements`.
  ThreadStates(const Model& model, int64_t statements, size_t state_max = kStateMax);

  /// The state of a thread of the model after the statements at its beginning that access no
  /// globals; Step::statements is their number. Empty as for StepOf().
  std::optional<Step> Begin(int thread);

  /// The next step of a thread that runs, for the current values of the globals. nullptr: there are
  /// too many states, steps or different accesses, or the step has too many statements. Valid until
  /// the next call.
  const Step* StepOf(uint32_t state, const std::vector<int64_t>& globals) {
    const State& from = states_[state];
    uint32_t step = from.steps;
    if (from.read == kReadsSeveral) {
      for (uint32_t i = 0; i < accesses_[from.access].read_count && step != kNone; ++i) {
        step = step_numbers_.Find(step, globals[accesses_[from.access].reads[i]]);
      }
    } else if (from.read != kReadsNothing) {
      step = step_numbers_.Find(step, globals[from.read]);
    }
    return step == kNone ? AddStep(state, globals) : &steps_[step];
  }

  bool Runs(uint32_t state) const { return states_[state].runs; }
  /// True if the thread has ended with an error.
  bool Failed(uint32_t state) const { return states_[state].failed; }
  /// The part of Model::key() that belongs to the thread.
  StateKey KeyOf(uint32_t state) const;
  /// The cells of a thread in a state (Model::ThreadCells()); valid until the next step is known.
  std::span<const int64_t> CellsOf(uint32_t state) const;
  int ThreadOf(uint32_t state) const { return states_[state].thread; }
  /// What the next step of a thread that runs accesses, as a number less than kAccessMax.
  uint8_t AccessOf(uint32_t state) const { return states_[state].access; }
  /// Bit n: two steps with these accesses depend on each other; n is the number of the other one.
  size_t access_count() const { return dependent_.size(); }
  uint64_t dependent(uint8_t access) const { return dependent_[access]; }

  /// Known states and steps are numbered from 0.
  size_t state_count() const { return states_.size(); }
  size_t step_count() const { return steps_.size(); }
  const Step& step(uint32_t number) const { return steps_[number]; }
  /// The number of a step that StepOf() has returned.
  uint32_t NumberOf(const Step* step) const { return static_cast<uint32_t>(step - steps_.data()); }

  /// The globals that known accesses write; there may be more of them after later steps.
  const std::vector<uint32_t>& written() const { return written_; }
  /// The globals at the beginning.
  const std::vector<int64_t>& globals() const { return globals_; }
  /// Gives a model of the same program these states of its threads, and the values of the globals
  /// that any known step writes. The model must be one that came from model().
  void Load(const std::vector<uint32_t>& states, const std::vector<int64_t>& globals,
            Model* model) const;
  /// The model at the beginning, without steps that can be undone.
  const Model& model() const { return start_; }

 private:
  static constexpr uint32_t kReadsNothing = kNone;
  static constexpr uint32_t kReadsSeveral = kNone - 1;
  struct State {
    uint8_t thread = 0;
    bool runs = false;
    bool failed = false;
    uint8_t access = 0;             ///< of the next step
    uint32_t read = kReadsNothing;  ///< the global that it reads
    uint32_t steps = kNone;         ///< the step, or its place in step_numbers_ if it reads globals
    uint32_t cells = 0;             ///< the thread's first one in cells_
  };

  const Step* AddStep(uint32_t state, const std::vector<int64_t>& globals);
  /// Executes the statements of a thread in scratch_ that belong to the step before them. Returns
  /// their number; empty if they are too many.
  std::optional<int64_t> FinishStep(int thread);
  /// The number of the state of a thread in scratch_; kNone if there are too many.
  uint32_t StateInScratch(int thread);
  /// The number of an access; empty if there are too many.
  std::optional<uint8_t> NumberOf(const AccessSet& access);

  Model start_;
  Model scratch_;
  int64_t statements_;
  size_t state_max_;
  std::vector<int64_t> globals_;
  std::vector<State> states_;
  std::vector<int64_t> cells_;  ///< of all states
  NumberTable state_numbers_;   ///< of a thread and the values of its cells
  uint32_t state_nodes_ = 0;
  std::vector<Step> steps_;
  NumberTable step_numbers_;  ///< of a state and the values that its step reads
  uint32_t step_nodes_ = 0;
  std::vector<AccessSet> accesses_;
  std::vector<uint64_t> dependent_;
  std::vector<uint32_t> written_;
};

}  // namespace oncard::explore
