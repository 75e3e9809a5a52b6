// The steps of a card's program between rows (card_rows.h). What a statement does is computed once
// for all rows that agree in what it accesses: its thread, the globals that it names, and of the
// body what the catalogue says that its command accesses. So is what a cycle makes of a body, and
// whether a condition holds.
//
// The first time, a statement or a cycle is executed on the card, which tells whether it has
// changed anything else. If it has, the steps are not exact, and who searches must begin again with
// whole states. What needs more than is known of rows (the end of a run, a failure, an assert) is
// executed on the card each time.
//
// What is known can be shared by searches one after the other, of cases that differ in the events
// outside and in the values at the start: a cycle in which no event happens is the same in all of
// them.
//
// Deterministic; not thread-safe. Tested by tests/explore/card_steps_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "explore/models/card_rows.h"
#include "explore/models/key_set.h"
#include "explore/models/recent_values.h"
#include "explore/models/value_table.h"
#include "gtcalls/catalogue.h"
#include "runtime/observe/statement_access.h"

namespace oncard::explore {

/// What is known of the steps of a card, and what their numbers mean.
struct KnownSteps {
  /// What a statement does.
  struct Statement {
    bool alone = false;  ///< it is executed on the card each time
    uint32_t thread = 0;
    std::optional<uint32_t> history;  ///< if it changes it
    std::vector<CardRows::GlobalWrite> globals;
    std::vector<std::pair<size_t, uint32_t>> body;  ///< its parts
    bool writes_outputs = false;                    ///< all of them; if outputs are watched
    bool tells = false;  ///< the card refuses something, or warns of something
  };
  struct Cycle {
    uint32_t body = 0;
    uint32_t history = 0;
    int64_t statements = 0;
    bool tells = false;  ///< the same
  };
  /// A cycle in which no event happens outside.
  struct PresentCycle {
    std::vector<uint32_t> parts;  ///< of the body, but for BodyDivision::kWorld
    uint32_t history = 0;
    int64_t statements = 0;
    bool tells = false;
  };
  /// What a command accesses of the body, beside the clock.
  struct BodyAccess {
    bool whole = false;
    std::vector<size_t> parts;
    std::vector<size_t> written;
  };
  struct Judgement {
    bool holds = false;
    bool answers = false;   ///< the right side of a response
    bool mattered = false;  ///< the condition of its guard holds
  };

  /// They are forgotten between searches where there are more bodies.
  static constexpr uint32_t kBodiesMax = 500'000;

  CardRows::Tables rows;
  ValueTable<Statement> statements;
  ValueTable<BodyAccess> accesses;
  ValueTable<Cycle> cycles;
  ValueTable<PresentCycle> present_cycles;
  ValueTable<Judgement> judgements;
};

class CardSteps : public CardRows {
 public:
  using State = Row;

  /// `known` are steps of models that differ only in their values at the start and in the events
  /// outside, or none.
  explicit CardSteps(CardModel* model,
                     const std::shared_ptr<KnownSteps>& known = std::make_shared<KnownSteps>());

  /// False: what was computed may be wrong.
  bool exact() const { return exact_ && CardRows::exact(); }

  /// As those of CardModel.
  Row Start();
  /// The row of a state of the model.
  Row From(const CardModel::State& state);
  Row Step(const Row& from, int thread);
  Row EndCycle(const Row& from);
  /// What the next statement of a thread accesses as long as other threads run beside it
  /// (runtime/observe/lasting_access.h); empty if that has been given before.
  runtime::StatementAccess NewLastingAccess(const Row& row, int thread);

  /// The locals that a command writes unless it is refused, by the code; of a command that changes
  /// the card none.
  struct Outputs {
    std::vector<size_t> operands;
    std::vector<uint16_t> slots;
  };
  const Outputs& OutputsOf(size_t function, size_t position) const {
    return instructions_[function][position].outputs;
  }
  /// Statements are watched from now on: whether they write all their outputs.
  void WatchOutputs() { watches_outputs_ = true; }
  /// True if the next statement of a thread does.
  bool WritesOutputs(const Row& row, size_t place) {
    return StatementOf(row, place).writes_outputs;
  }

 private:
  using Statement = KnownSteps::Statement;
  using BodyAccess = KnownSteps::BodyAccess;
  using Cycle = KnownSteps::Cycle;
  using PresentCycle = KnownSteps::PresentCycle;
  using Judgement = KnownSteps::Judgement;

  /// What is known of an instruction of the program.
  struct Instruction {
    bool alone = false;
    bool all_globals = false;
    std::vector<uint16_t> globals;  ///< those that it can access
    const gtcalls::Command* command = nullptr;
    bool reads_body = false;
    bool changes_body = false;
    bool looks_around = false;  ///< Supervisor::LooksAround()
    /// What it does depends on more than its thread, the globals and the body.
    bool sees_others() const { return changes_body || looks_around; }
    Outputs outputs = {};
  };
  /// What the names of a condition are parts of.
  struct Names {
    bool globals = false;
    bool threads = false;
    bool body = false;
  };
  void PlanInstructions();
  static void AddNames(const runtime::CardCondition& condition, Names* names);
  void AddToKey(const Row& row, const Names& names);

  Row StepAlone(const Row& from, int thread);
  // As those of CardModel. False: the step must be executed on the card.
  bool Settle(Row* row, Progress* progress);
  bool NextCycle(Row* row, Progress* progress);
  bool Judge(const Row& row, Progress* progress);
  /// False if a requirement on every state holds after a statement because it did before.
  bool MayViolate(const Row& before, const Row& after) const;

  const Statement& StatementOf(const Row& row, size_t place);
  const Statement& FindStatement(const Row& row, size_t place, const Instruction& instruction);
  void AddToKey(const Row& row, const Instruction& instruction, const BodyAccess* access);
  void PlanOutputs(const vm::Instruction& instruction, Instruction* plan) const;
  bool WritesOutputs(const Row& row, size_t place, const Instruction& instruction,
                     const Thread& after);
  const BodyAccess& AccessOf(const Row& row, size_t place, const Instruction& instruction);
  BodyAccess NextBodyAccess(int number) const;
  Statement Execute(const Row& row, size_t place, const Instruction& instruction,
                    const BodyAccess* access);
  const Cycle& CycleAfter(const Row& row);
  Cycle ExecuteCycle(const Row& row);
  /// What the card has refused and warned of so far.
  int64_t Told() const;
  const Judgement& JudgementOf(const Row& row, size_t requirement);

  CardModel& model_;
  runtime::Controller& card_;
  bool exact_ = true;
  bool watches_outputs_ = false;
  std::vector<std::vector<Instruction>> instructions_;  ///< by function and position
  std::vector<Names> names_;                            ///< of the requirements
  Names watched_;                                       ///< of those on every state
  bool watches_time_ = false;                           ///< one of them asks what came before
  Names reaction_names_;                                ///< of all reactions

  KnownSteps& known_;
  RecentValues<Statement> recent_statements_;
  // What tells something does so once a search, also if it is known from another one.
  std::set<uint32_t> told_statements_;
  std::set<uint32_t> told_cycles_;
  KeySet lasting_;  ///< what NewLastingAccess() depends on
  std::vector<int64_t> key_;
};

}  // namespace oncard::explore
