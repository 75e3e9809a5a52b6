// Data races: two statements of different threads that touch a variable, one of them writing it,
// without anything that orders them. Accesses to a synchronising variable (a flag, a lock) order:
// what a thread did before it wrote one happens before what another one does after reading that.
//
// A program races under some schedule exactly when it has a state in which two threads are about to
// touch a variable in this way; FindRaces() looks at states. RaceDetector finds the races of one
// run by vector clocks, also between statements that are far apart. Deterministic. Tested by
// tests/explore/races_test.cc.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "explore/models/model.h"

namespace oncard::explore {

struct RacingStatement {
  int thread = 0;    ///< as the model counts
  int position = 0;  ///< of the statement in its function
  bool writes = false;
  auto operator<=>(const RacingStatement&) const = default;
};

/// `first` is that of the smaller thread (FindRaces), or the earlier one (RaceDetector).
struct Race {
  uint32_t cell = AccessSet::kNone;  ///< kNone: there is no race
  RacingStatement first;
  RacingStatement second;

  explicit operator bool() const { return cell != AccessSet::kNone; }
  auto operator<=>(const Race&) const = default;
};

/// Which races are wrong.
enum class RaceRule : uint8_t {
  kAny,     ///< all are allowed, none is looked for
  kBenign,  ///< those that change no final value are allowed
  kNone     ///< no race is allowed
};

/// The shared cells that synchronise; element n is true for cell n, missing ones are false.
using SyncCells = std::vector<bool>;

/// The races between what the running threads are about to do.
std::vector<Race> FindRaces(const Model& model, const SyncCells& sync);

/// The races of one run, statement by statement.
class RaceDetector {
 public:
  RaceDetector(const Model& model, const SyncCells& sync);

  /// Told before each statement; a race between it and an earlier one, if there is any.
  Race BeforeStep(const Model& model, int thread);
  /// Names what it knows: which races later statements have depends on it.
  StateKey Key() const;

 private:
  /// A thread's clock at an access, 0 for none, and where that was.
  struct Access {
    uint32_t clock = 0;
    int position = 0;
  };
  using Clock = std::vector<uint32_t>;  ///< one element per thread
  struct Cell {
    std::vector<Access> reads;  ///< of every thread, the latest
    std::vector<Access> writes;
  };

  Cell& CellAt(uint32_t cell);
  Clock& SyncAt(uint32_t cell);
  /// The access of another thread that nothing orders before this thread's present.
  Race Unordered(const std::vector<Access>& accesses, bool writes, uint32_t cell,
                 const RacingStatement& present) const;

  const SyncCells& sync_;
  size_t threads_;
  std::vector<Clock> clocks_;       ///< of the threads
  std::vector<Cell> cells_;         ///< those touched so far; index: cell
  std::vector<Clock> sync_clocks_;  ///< of synchronising cells; index: cell
};

}  // namespace oncard::explore
