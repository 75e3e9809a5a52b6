// The states of a card with its program (card_model.h) as rows of numbers: a number for what each
// thread is, with its page, one for the globals, one for the body of the card, and one for the
// progress of the cycle and of the requirements. Equal parts have equal numbers, so that two rows
// are equal exactly if CardModel::KeyOf() is.
//
// Not every model has rows: with a recorded host, where the past decides races, or where a
// condition counts statements, states are whole ones.
//
// Deterministic; not thread-safe. Tested by tests/explore/card_rows_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/message.h"
#include "explore/models/card_model.h"
#include "explore/models/key_set.h"
#include "explore/models/state_key.h"
#include "explore/models/value_table.h"
#include "runtime/sim/body_parts.h"

namespace oncard::explore {

class CardRows {
 public:
  /// A state. Its parts say what its future is: of each thread, the globals, the body, the
  /// progress.
  struct Row {
    std::array<uint32_t, vm::kThreadCount + 3> parts{};
    uint32_t history = 0;   ///< what the supervisor remembers
    uint32_t fault = 0;     ///< the number of CardModel::State::fault; 0: none
    bool finished = false;  ///< as in CardModel::State
  };
  struct Thread {
    vm::ThreadState state;
    std::vector<int64_t> page;  ///< without the zeros at its end
  };
  /// What tells whether a thread can go on, and with which statement. Searches ask for this much
  /// more often than for the rest, so it is kept apart.
  struct Position {
    int64_t wake_cycle = 0;  ///< as in vm::ThreadState
    uint16_t pc = 0;
    uint8_t function = 0;
    bool running = false;
    bool waiting = false;
    bool at_end = false;  ///< of its function: it finishes when it wakes up
  };
  struct Body {
    std::vector<uint32_t> parts;  ///< runtime::BodyDivision
    int64_t cycle = 0;
    bool apart = false;  ///< its axes do not depend on each other
    /// Bodies that differ only in the events that are still to come outside have the same number.
    uint32_t present = 0;
    bool event_soon = false;  ///< one can happen in the next cycle
  };
  /// What CardModel::State has of the cycle and of the requirements.
  struct Progress {
    int64_t left = 0;
    uint32_t served = 0;
    uint32_t reached = 0;
    bool ended = false;
    Fault::Kind fault = Fault::Kind::kNone;
    std::vector<runtime::Owed> owed;
  };
  struct GlobalWrite {
    uint32_t slot = 0;
    int64_t value = 0;
  };

  /// What the numbers mean.
  struct Tables {
    struct BodyPart {
      runtime::BodyDivision::Part value;
      bool apart = false;
    };

    ValueTable<Thread> threads;
    std::vector<Position> positions;  ///< of `threads`, by their numbers
    /// The number of the globals and their values, without the zeros at their end; then the number,
    /// the size and the values of each page that has no thread.
    ValueTable<std::vector<int64_t>> globals;
    std::vector<ValueTable<BodyPart>> body_parts;
    ValueTable<Body> bodies;
    KeySet presents;  ///< Body::present
    ValueTable<Progress> progresses;
    /// By the number of a progress and the place of a thread: what it is after a statement.
    std::vector<uint32_t> progresses_after;
    ValueTable<runtime::Supervisor::HistoryPointer> histories;
  };

  /// The model has a card in a state of its own from now on. Rows of models that differ only in
  /// their values at the start and in the events outside can share their tables.
  CardRows(CardModel* model, std::shared_ptr<Tables> tables);
  CardRows(const CardRows&) = delete;
  CardRows& operator=(const CardRows&) = delete;

  /// Why the model has no rows; empty: it has.
  static std::optional<Message> WhyNot(const CardModel& model);
  static bool Possible(const CardModel& model) { return !WhyNot(model); }
  /// False: a row does not say everything that the future depends on. Known when it is made.
  bool exact() const { return exact_; }

  /// From now on bodies that differ only in what is left of ended runs are one
  /// (motion::Profile::ForgetRuns()).
  void ForgetRuns() { forgets_runs_ = true; }

  /// A key of a row, with a number that tells equal ones apart.
  StateKey KeyOf(const Row& row, uint32_t number = 0) const;
  bool Ended(const Row& row) const { return ProgressOf(row).ended; }
  int64_t CycleOf(const Row& row) const { return BodyOf(row).cycle; }
  /// The threads that may execute the next statement, by their numbers in the model.
  uint32_t ChoicesOf(const Row& row) const;
  /// CardModel::MayEndCycle().
  bool MayEndCycle(const Row& row) const;
  /// The same state as a whole one.
  CardModel::State Whole(const Row& row);
  /// Its variables and threads alone.
  CardModel::State Program(const Row& row);

  // --- Parts. Threads have the places of their numbers on the card, in ascending order ---------

  size_t thread_count() const { return numbers_.size(); }
  int NumberOnCard(size_t place) const { return numbers_[place]; }
  size_t PlaceOf(int thread) const { return places_[static_cast<size_t>(thread)]; }
  static uint32_t ThreadNumber(const Row& row, size_t place) { return row.parts[place]; }
  uint32_t GlobalsNumber(const Row& row) const { return row.parts[thread_count()]; }
  uint32_t BodyNumber(const Row& row) const { return row.parts[thread_count() + 1]; }
  const Thread& ThreadOf(const Row& row, size_t place) const {
    return tables_->threads[ThreadNumber(row, place)];
  }
  const Position& PositionOf(const Row& row, size_t place) const {
    return tables_->positions[ThreadNumber(row, place)];
  }
  const Body& BodyOf(const Row& row) const { return tables_->bodies[BodyNumber(row)]; }
  const Progress& ProgressOf(const Row& row) const {
    return tables_->progresses[row.parts[thread_count() + 2]];
  }
  const runtime::Supervisor::HistoryPointer& HistoryOf(const Row& row) const {
    return tables_->histories[row.history];
  }
  const runtime::BodyDivision& division() const { return division_; }
  /// The value of a global.
  int64_t ValueOf(const Row& row, uint32_t slot) const;
  /// The threads that could execute a statement, by their numbers on the card.
  uint32_t Runnable(const Row& row) const;
  /// True if a thread finishes because it wakes up at the end of its function.
  bool SomeoneFinishes(const Row& row) const;

  void SetThread(size_t place, uint32_t number, Row* row) const { row->parts[place] = number; }
  /// The number of a thread with these values in its page.
  uint32_t NumberOfThread(const vm::ThreadState& state, std::vector<int64_t> page);
  void SetBody(uint32_t number, Row* row) const { row->parts[thread_count() + 1] = number; }
  /// The number of a body with these parts.
  uint32_t NumberOfParts(std::vector<uint32_t> parts);
  /// Changes parts of the body.
  void SetBodyParts(const std::vector<std::pair<size_t, uint32_t>>& parts, Row* row);
  void WriteGlobals(const std::vector<GlobalWrite>& writes, Row* row);
  void SetProgress(Progress progress, Row* row);
  /// A thread has executed a statement of the cycle.
  void NoteStatement(size_t place, Row* row);

  // --- Between rows and the card ---------------------------------------------------------------

  /// Puts the card into the state, without and with its body.
  void LoadMachine(const Row& row);
  void Load(const Row& row);
  /// The present state of the card; of `state` what the card does not have.
  Row RowOfCard(const CardModel::State& state);
  /// What the card does not have: the inverse.
  CardModel::State StateFor(const Row& row) const;
  // The numbers of what the card is now.
  uint32_t NumberOfThread(size_t place);
  uint32_t NumberOfGlobals();
  uint32_t NumberOfBody();
  uint32_t NumberOfHistory();
  /// The globals that differ; `others`: so does something that belongs to no thread.
  std::vector<GlobalWrite> Differences(uint32_t before, uint32_t after, bool* others) const;
  const Body& BodyWith(uint32_t number) const { return tables_->bodies[number]; }
  const Thread& ThreadWith(uint32_t number) const { return tables_->threads[number]; }

 private:
  size_t part_count() const { return thread_count() + 3; }
  /// Gives `body_` the part with its number among these.
  void PutPart(size_t part, const std::vector<uint32_t>& numbers);
  bool EventSoon(const motion::MotionState& state) const;
  uint32_t NumberOfWords(std::vector<int64_t> globals);
  bool CanContinue(const Row& row, size_t place) const;

  CardModel& model_;
  runtime::Controller& card_;
  bool exact_ = true;
  bool forgets_runs_ = false;
  runtime::BodyDivision division_;
  std::vector<int> numbers_;    ///< of the bound threads on the card
  std::vector<size_t> places_;  ///< of the model's threads among them

  std::shared_ptr<Tables> tables_;
  std::vector<Fault> faults_;  ///< of rows; the first one is none

  std::unique_ptr<vm::MachineState> machine_;  ///< large
  runtime::CardBody body_;
  std::vector<uint32_t> body_numbers_;  ///< of the parts that body_ has
  motion::StateWords words_;
  std::vector<int64_t> key_;
};

}  // namespace oncard::explore
