// Which statements of a run nothing orders, up to the first two: what vm/race_clocks.h answers, as
// a small value for searches of states. In place of clocks it keeps the accesses with which a later
// one can still race, and who knows of each: threads and synchronising cells. Runs after which the
// same accesses are known to the same are equal, however they came there.
//
// Threads are numbered from 0, and so are synchronising cells, apart from the others. Nothing is
// promised after the first race. Deterministic. Tested by tests/vm/race_history_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vm/limits.h"
#include "vm/race_clocks.h"

namespace oncard::vm {

class RaceHistory {
 public:
  RaceHistory(size_t threads, size_t sync_cells);

  void Acquire(int thread, size_t sync_cell);
  void Release(int thread, size_t sync_cell);
  /// As the functions of RaceClocks.
  std::optional<RacingAccess> Read(int thread, int position, uint32_t cell);
  std::optional<RacingAccess> Write(int thread, int position, uint32_t cell);

  bool operator==(const RaceHistory&) const = default;

  /// Calls `add` with numbers that determine whether later accesses race.
  template <typename Add>
  void ForEachNumber(Add&& add) const {
    for (const Access& access : accesses_) {
      add(int64_t{access.cell} << 16 | int64_t{access.thread} << 1 | int64_t{access.writes});
    }
    for (const uint64_t word : knowers_) add(static_cast<int64_t>(word));
  }

 private:
  struct Access {
    uint32_t cell = 0;
    int thread = 0;
    bool writes = false;
    int position = 0;
    bool operator==(const Access&) const = default;
  };

  /// The place of a synchronising cell among those who can know of an access, behind the threads.
  static size_t PlaceOf(size_t sync_cell) { return kThreadCount + sync_cell; }
  bool Knows(size_t access, size_t who) const {
    return (knowers_[access * words_ + who / 64] >> who % 64 & 1) != 0;
  }
  void Tell(size_t access, size_t who) {
    knowers_[access * words_ + who / 64] |= uint64_t{1} << who % 64;
  }
  void Remove(size_t access);
  /// Notes an access that only its thread knows of.
  void Add(const Access& access);
  /// An access of another thread to the cell of which the thread does not know.
  std::optional<RacingAccess> Unordered(int thread, uint32_t cell, bool writes) const;

  uint64_t all_threads_ = 0;
  size_t words_ = 0;               ///< of knowers_ for each access
  std::vector<Access> accesses_;   ///< by cell, thread and kind
  std::vector<uint64_t> knowers_;  ///< a bit for each thread and synchronising cell
};

}  // namespace oncard::vm
