// What a machine has executed, as it is recorded. Threads that take turns after every statement
// make millions of segments; here a round of them is kept once, with the number of its repetitions.
// Tested by tests/vm/recording_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "vm/schedule.h"

namespace oncard::vm {

/// Rounds that are alike: in each, every one of the threads executes one statement. They are in
/// ascending order from `first` on, and after thread 31 follows thread 0.
struct RecordedRounds {
  uint32_t threads = 0;  ///< bit n: thread n; not 0
  uint8_t first = 0;     ///< one of them
  int64_t rounds = 0;    ///< with a single thread: its statements in a row
};

/// The parts of a Schedule, with rounds instead of segments.
struct Recording {
  uint64_t program_hash = 0;
  std::string scenario;
  std::vector<RecordedRounds> rounds;
  std::vector<ScheduleCheckpoint> checkpoints;
  std::optional<int64_t> cut_us;

  /// Appends `statements` > 0 in a row of one thread. Turns that make rounds are found.
  void AddTurn(int thread, int64_t statements);
  void AddRounds(const RecordedRounds& added);
};

/// The same as a schedule.
Schedule ScheduleOf(const Recording& recording);

/// The text of its schedule file: FormatSchedule(ScheduleOf(recording)), without the memory that
/// the segments would need.
std::string FormatRecording(const Recording& recording);

}  // namespace oncard::vm
