// Which statements of a run nothing orders: vector clocks of the threads. What a thread did before
// it released a cell, such as a flag or a lock, happens before what another thread does after it
// has acquired the cell. Two accesses of different threads to a cell race if one of them writes it
// and neither happens before the other.
//
// The caller tells of each statement, in the order of the run, what it acquires, reads, writes and
// releases, in this order. Cells are numbers. A copy goes on by itself. Deterministic. Tested by
// tests/vm/race_clocks_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace oncard::vm {

/// An access to a cell that a later one races with.
struct RacingAccess {
  int thread = 0;
  int position = 0;  ///< index of the statement in its function
  bool writes = false;
};

class RaceClocks {
 public:
  /// Threads are numbered from 0.
  explicit RaceClocks(size_t threads);

  void Acquire(int thread, uint32_t cell);
  void Release(int thread, uint32_t cell);
  /// Notes an access of the statement at `position`, and returns an earlier one of another thread
  /// that it races with, if there is any.
  std::optional<RacingAccess> Read(int thread, int position, uint32_t cell);
  std::optional<RacingAccess> Write(int thread, int position, uint32_t cell);

  /// Calls `add` with numbers that determine the answers to all that follows.
  template <typename Add>
  void ForEachNumber(Add&& add) const {
    for (const std::vector<Clock>* clocks : {&clocks_, &released_}) {
      for (const Clock& clock : *clocks) {
        add(static_cast<int64_t>(clock.size()));
        for (const uint32_t time : clock) add(int64_t{time});
      }
    }
    for (const Cell& cell : cells_) {
      for (const std::vector<Access>* accesses : {&cell.reads, &cell.writes}) {
        add(static_cast<int64_t>(accesses->size()));
        for (const Access& access : *accesses) {
          add(int64_t{access.clock});
          add(int64_t{access.position});
        }
      }
    }
  }

 private:
  /// A thread's clock at an access, 0 for none, and the statement.
  struct Access {
    uint32_t clock = 0;
    int position = 0;
  };
  using Clock = std::vector<uint32_t>;  // one element per thread
  struct Cell {
    std::vector<Access> reads;  // the latest access of every thread
    std::vector<Access> writes;
  };

  Cell& CellAt(uint32_t cell);
  Clock& ReleasedAt(uint32_t cell);
  std::optional<RacingAccess> Unordered(const std::vector<Access>& accesses, bool writes,
                                        int thread) const;

  std::vector<Clock> clocks_;    // of the threads
  std::vector<Cell> cells_;      // accesses so far; index: cell
  std::vector<Clock> released_;  // of the cells that were released; index: cell
};

}  // namespace oncard::vm
