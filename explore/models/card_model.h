// A card that runs a motion program, as a transition system: threads that take one statement at a
// time, and the motion core and the clock around them.
//
// Time belongs to the state. A profile cycle has as many statements as the scenario's rate says;
// when they are used up, or no thread can take one, the next cycle begins by itself: motion, inputs
// and delays go on. What is free is the order in which the threads take their statements of a
// cycle, with one restriction, without which a thread could be held up for ever: a thread that can
// go on gets at least one statement in every cycle.
//
// States are values; Step() goes from one to the next. Deterministic; not thread-safe. Tested by
// tests/explore/card_model_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "base/result.h"
#include "explore/models/model.h"
#include "explore/models/problem.h"
#include "explore/models/state_key.h"
#include "runtime/scenario/scenario.h"
#include "runtime/sim/controller.h"

namespace oncard::explore {

class CardModel {
 public:
  /// What changes with commands and cycles only; most states share it with the one before.
  struct Body;
  /// A state between two statements.
  struct State {
    std::vector<int64_t> slots;  ///< the globals, then the pages that hold something
    uint32_t used_pages = 0;
    std::array<vm::ThreadState, vm::kThreadCount> threads{};
    int64_t executed = 0;
    std::shared_ptr<const Body> body;
    int64_t left = 0;       ///< statements of the cycle that are left
    uint32_t served = 0;    ///< threads that have had one in the cycle, by number on the card
    bool ended = false;     ///< nothing happens any more that the scenario asks for
    bool finished = false;  ///< it has ended because no thread runs any more
    uint32_t choices = 0;   ///< bit n: thread n of the model may take the next statement
    uint32_t reached = 0;   ///< bit n: the n-th kEventually has held on the way
    Fault fault;            ///< what is wrong with it, or with a cycle that led to it
  };

  /// The scenario's program on a card of its own, before the first statement; its expectations must
  /// hold, and the requirements. Its host events are passed over. Fails when the scenario does not
  /// fit the program, or a requirement is no expression.
  static Result<CardModel> Create(const runtime::Scenario& scenario,
                                  const std::vector<Requirement>& requirements, vm::Object object);

  /// The bound threads, in the order of their numbers on the card.
  int thread_count() const { return static_cast<int>(setups_.size()); }
  const ThreadSetup& setup(int thread) const { return setups_[static_cast<size_t>(thread)]; }
  const std::vector<ThreadSetup>& setups() const { return setups_; }
  const std::shared_ptr<const vm::Image>& image() const { return image_; }
  /// What must hold: the scenario's expectations, then the requirements.
  std::vector<Requirement> Requirements() const;
  /// True when there are none.
  bool asks_nothing() const { return requirements_.empty(); }
  /// The card, as the last Start(), Step() or Load() left it.
  const runtime::Controller& controller() const { return *controller_; }
  /// Commands that threads have been refused in any of the steps that were taken.
  const std::vector<runtime::RefusedCommand>& refused() const { return refused_->list(); }

  /// The first state in which a thread has a choice, or the end.
  State Start();
  /// The state after a statement of a thread that may take it, and whatever then happens by itself.
  State Step(const State& state, int thread);
  /// Puts the card into a state.
  void Load(const State& state);

  // The same for a run that nobody comes back to, which is much faster: the card itself goes on,
  // and the state's `slots`, `threads` and `body` are not kept up to date. Until the run is over
  // nothing else may use the model.

  State Begin();
  void Advance(State* state, int thread);
  /// Up to `most` statements of a thread within its cycle: several where no other thread runs and
  /// nothing has to hold on the way. Gives how many.
  int64_t AdvanceAlone(State* state, int thread, int64_t most);
  /// The whole of such a state, which the card is in: one that can be loaded again.
  State Whole(const State& state);
  /// Takes the variables and threads of the card over into the state.
  void CopyVariables(State* state) const;
  /// Whether the next statements of two threads touch the same, and one writes it, as the card
  /// stands.
  bool NextDependOnEachOther(int a, int b) const;

  /// Names all that the future depends on.
  StateKey KeyOf(const State& state) const;
  /// Name the final values of the globals alone, and with what the threads returned.
  StateKey GlobalsKey(const State& state) const;
  StateKey FinalKey(const State& state) const;

 private:
  struct BoundRequirement {
    Requirement requirement;
    std::variant<runtime::BoundExpectation, Property> condition;
    int64_t cycle = -1;  ///< an expectation with an instant: at the end of this cycle
  };

  CardModel() = default;
  Result<void> BindRequirements(const std::vector<Requirement>& requirements);
  bool Holds(const BoundRequirement& bound) const;
  /// Looks at the final requirements that have no instant and at what should have held by now.
  void JudgeEnd(State* state) const;
  /// Looks at what must hold now, and at what must hold some time.
  void JudgeState(State* state) const;
  /// Looks at the expectations whose instant is the end of this cycle.
  void JudgeInstant(State* state) const;
  void JudgeThreads(State* state) const;
  /// Begins cycles until a thread has a choice or the run has ended.
  void Settle(State* state);
  /// Ends the run: what it was for is looked at.
  void End(State* state);
  /// The threads that may take the next statement, by number on the card.
  uint32_t Candidates(const State& state) const;
  /// Takes over what the card holds; `body`, if it is still that.
  void Save(const std::shared_ptr<const Body>& body, State* state);

  runtime::Scenario scenario_;
  std::shared_ptr<const vm::Image> image_;
  std::unique_ptr<runtime::RefusedCommands> refused_ = std::make_unique<runtime::RefusedCommands>();
  std::unique_ptr<runtime::Controller> controller_;
  std::shared_ptr<const Body> held_;           ///< what the controller's body is equal to
  State initial_;                              ///< before the first cycle
  std::unique_ptr<vm::MachineState> scratch_;  ///< large
  std::vector<ThreadSetup> setups_;
  std::vector<BoundRequirement> requirements_;
  uint32_t fault_expected_ = 0;  ///< threads whose error an expectation names
  bool has_invariants_ = false;  ///< or kEventually
  int64_t last_cycle_ = 0;       ///< `until_ms` or `limit_ms`
  bool last_is_failure_ = true;  ///< it is the latter
  int64_t last_instant_ = 0;     ///< cycle of the last expectation with an instant, or `until_ms`
};

}  // namespace oncard::explore
