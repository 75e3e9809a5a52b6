// A recorded schedule: which thread executed how many statements in a row, with hashes of
// intermediate states, so that a deviation of a replay is detected where it occurs. The text form
// is described in docs/schedule-format.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace oncard::vm {

/// `statements` in a row of one thread.
struct ScheduleSegment {
  uint8_t thread = 0;
  int64_t statements = 0;
  bool operator==(const ScheduleSegment&) const = default;
};

/// Where in the source a segment stops, for replays of an edited program.
struct ScheduleStop {
  int line = 0;        ///< of the thread's next statement; 0: it has ended
  int64_t passes = 0;  ///< how often the thread reached a line with this text in the segment
  std::string text;    ///< of that line
  bool operator==(const ScheduleStop&) const = default;
};

/// The machine's hash after `statement` statements of the whole run.
struct ScheduleCheckpoint {
  int64_t statement = 0;
  uint64_t hash = 0;
  bool operator==(const ScheduleCheckpoint&) const = default;
};

struct Schedule {
  uint64_t program_hash = 0;  ///< Image::hash
  /// The scenario that was run (TOML text), so that the file can be replayed on its own.
  std::string scenario;
  std::vector<ScheduleSegment> segments;
  std::vector<ScheduleStop> stops;  ///< one for each segment, or none at all
  std::vector<ScheduleCheckpoint> checkpoints;
  /// The run was cut off at this instant, in us of virtual time, although threads could still run:
  /// by a signal, or because no more was to be recorded. Empty: the run ended.
  std::optional<int64_t> cut_us;
  bool operator==(const Schedule&) const = default;
};

/// The scenario's text in the file begins after this number of lines, and each of its lines has
/// this prefix.
inline constexpr int kLinesBeforeScenario = 3;
inline constexpr std::string_view kScenarioPrefix = "| ";

/// Statements between two checkpoints of a recording.
inline constexpr int64_t kCheckpointInterval = 10000;

/// The text of a schedule file; ends in a newline, byte-deterministic.
std::string FormatSchedule(const Schedule& schedule);

/// Reads it back. The error names the line.
Result<Schedule> ParseSchedule(std::string_view text);

/// The same for the text of a file; errors begin with its path.
Result<Schedule> ParseScheduleFile(const std::string& path, std::string_view text);

/// Reads a schedule file; errors begin with its path.
Result<Schedule> LoadSchedule(const std::string& path);

}  // namespace oncard::vm
