// Data races: two statements of different threads access a variable, one of them writes it, and
// nothing orders them. Accesses to a synchronising variable (a flag, a lock) establish an order:
// what a thread did before it wrote the variable happens before what another thread does after
// reading it.
//
// A program has a race under some schedule exactly if it has a state in which two threads are about
// to access a variable in this way; FindRaces() examines states. RaceDetector finds the races of
// one run with vector clocks, also between statements that are far apart. Deterministic. Tested by
// tests/explore/races_test.cc.
//
// With a card, time keeps statements apart without ordering them, so the past of each state counts
// (CardRaces); and commands race by what they set (runtime/observe/race_steps.h). Tested by
// tests/explore/card_races_test.cc.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "explore/models/model.h"
#include "runtime/sim/controller.h"
#include "vm/race_clocks.h"
#include "vm/race_history.h"

namespace oncard::explore {

struct RacingStatement {
  int thread = 0;    ///< number in the model
  int position = 0;  ///< index of the statement in its function
  bool writes = false;
  std::string_view command = {};  ///< with which it sets something; empty: it accesses a variable
  auto operator<=>(const RacingStatement&) const = default;  // NOLINT(modernize-use-nullptr)
};

/// `first` belongs to the thread with the smaller number (FindRaces), or is the earlier one
/// (RaceDetector).
struct Race {
  uint32_t cell =
      AccessSet::kNone;  ///< kNone: there is no race; as in runtime/observe/race_steps.h
  RacingStatement first;
  RacingStatement second;

  explicit operator bool() const { return cell != AccessSet::kNone; }
  auto operator<=>(const Race&) const = default;  // NOLINT(modernize-use-nullptr)
};

/// Which races are failures.
enum class RaceRule : uint8_t {
  kAny,     ///< all are allowed, and none is searched for
  kBenign,  ///< those that change no final value are allowed
  kNone     ///< no race is allowed
};

/// The shared cells that synchronise; element n is true for cell n, missing ones are false.
using SyncCells = std::vector<bool>;

/// The races between the next statements of the running threads.
std::vector<Race> FindRaces(const Model& model, const SyncCells& sync);

/// What of the past of a state with its card decides which later statements race. A value; threads
/// are numbered as in the model. Nothing is promised after the first race.
class CardRaces {
 public:
  /// `ordering`: the globals that order (runtime::OrderingGlobals). `threads`: the numbers on the
  /// card.
  CardRaces(std::vector<bool> ordering, std::vector<int> threads);

  /// To be called before and after each statement of a thread; returns a race between it and an
  /// earlier one, if there is any.
  Race BeforeStatement(const runtime::Controller& controller, int thread);
  void AfterStatement(const runtime::Controller& controller, int thread);

  bool operator==(const CardRaces&) const = default;
  /// Adds numbers that determine the races of later statements.
  void AddTo(std::vector<int64_t>* words) const;

 private:
  static constexpr int16_t kNone = -1;
  /// What does not change in a run.
  struct Program {
    std::vector<bool> ordering;
    std::vector<size_t> places;  ///< of the ordering globals in the history, by their slots
    std::vector<int> threads;
  };

  std::shared_ptr<const Program> program_;
  /// The variables for which threads wait: when a thread goes on it has seen their values.
  std::vector<int16_t> awaited_;
  vm::RaceHistory history_;
};

/// The races of one run, statement by statement.
class RaceDetector {
 public:
  RaceDetector(const Model& model, const SyncCells& sync);

  /// To be called before each statement; returns a race between it and an earlier one, if there is
  /// any.
  Race BeforeStep(const Model& model, int thread);
  /// A key of its state, which determines the races of later statements.
  StateKey Key() const;

 private:
  const SyncCells& sync_;
  vm::RaceClocks clocks_;
};

}  // namespace oncard::explore
