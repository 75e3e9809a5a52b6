// The lines of a schedule file: reads them one by one, and puts the text together. Internal to
// schedules and recordings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "vm/schedule.h"

namespace oncard::vm {

inline constexpr std::string_view kFirstLine = "oncard-schedule 1";

/// Reads a text line by line.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  bool AtEnd() const { return rest_.empty(); }
  int line_number() const { return line_number_; }

  std::string_view Next() {
    ++line_number_;
    const size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

 private:
  std::string_view rest_;
  int line_number_ = 0;
};

/// The line of a segment.
std::string LineOf(const ScheduleSegment& segment);

class ScheduleText {
 public:
  /// The checkpoints must outlive this object.
  ScheduleText(uint64_t program_hash, std::string_view scenario,
               std::span<const ScheduleCheckpoint> checkpoints);

  /// Makes room for so many more characters.
  void Reserve(size_t more) { text_.reserve(text_.size() + more); }
  void AddRun(const ScheduleSegment& segment);
  /// The lines of several segments, with so many statements together.
  void AddRuns(std::string_view lines, int64_t statements) {
    text_ += lines;
    total_ += statements;
  }
  void AddNext(const ScheduleStop& stop);
  /// The checkpoints up to the present statement.
  void AddChecks();
  /// Statements from here to the next checkpoint; INT64_MAX: there is none.
  int64_t UntilCheck() const {
    return checkpoints_.empty() ? INT64_MAX : checkpoints_.front().statement - total_;
  }
  /// Ends the text and returns it.
  std::string Finish(const std::optional<int64_t>& cut_us);

 private:
  std::string text_;
  std::span<const ScheduleCheckpoint> checkpoints_;  // to come
  int64_t total_ = 0;                                // statements
};

}  // namespace oncard::vm
