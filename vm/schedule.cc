// The text of schedule files (schedule_text.h puts it together). Line by line:
//
//   oncard-schedule 1
//   program 0123456789abcdef
//   scenario 3                  how many lines of scenario text follow, each after "| "
//   | program = "sum.c"
//   run 0 5                     thread, statements
//   next 12 1 g = r + 1;        optional: source line of its next statement, how often the thread
//                               came to it, its text; `next 0 0` at the end of the thread
//   check 10000 0123456789abcdef
//   cut 5000250                 optional: the run was cut off at this time in us
//   end 12
//
// `end` gives the total number of statements, so that a truncated file is noticed.
// Tested by tests/vm/schedule_test.cc.
#include "vm/schedule.h"

#include <fmt/core.h>

#include <optional>

#include "base/files.h"
#include "base/number.h"
#include "vm/limits.h"
#include "vm/schedule_text.h"

namespace oncard::vm {
namespace {

// Removes the first word, up to a space, and returns it.
std::string_view TakeWord(std::string_view& line) {
  const size_t space = line.find(' ');
  const std::string_view word = line.substr(0, space);
  line.remove_prefix(space == std::string_view::npos ? line.size() : space + 1);
  return word;
}

Error BadLine(const LineReader& reader, std::string_view expected_en,
              std::string_view expected_zh) {
  return MakeError(1, "line {0} of the schedule: expected {1}", "调度文件第 {0} 行：应为{2}",
                   reader.line_number(), expected_en, expected_zh);
}

}  // namespace

std::string FormatSchedule(const Schedule& schedule) {
  ScheduleText text(schedule.program_hash, schedule.scenario, schedule.checkpoints);
  constexpr size_t kShortLine = sizeof "run 0 1";
  text.Reserve(schedule.segments.size() * kShortLine);
  for (size_t i = 0; i < schedule.segments.size(); ++i) {
    text.AddRun(schedule.segments[i]);
    if (i < schedule.stops.size()) text.AddNext(schedule.stops[i]);
    text.AddChecks();
  }
  return text.Finish(schedule.cut_us);
}

Result<Schedule> ParseSchedule(std::string_view text) {
  LineReader reader(text);
  Schedule schedule;
  if (reader.Next() != kFirstLine) {
    return BadLine(reader, "'oncard-schedule 1'", "“oncard-schedule 1”");
  }

  std::string_view line = reader.Next();
  const bool is_program = TakeWord(line) == "program";
  const auto program_hash = ReadWhole<uint64_t>(line, 16);
  if (!is_program || !program_hash) {
    return BadLine(reader, "'program' and its hash", "“program”及其散列值");
  }
  schedule.program_hash = *program_hash;

  line = reader.Next();
  const bool is_scenario = TakeWord(line) == "scenario";
  const auto scenario_lines = ReadWhole<int>(line);
  if (!is_scenario || !scenario_lines || *scenario_lines < 0) {
    return BadLine(reader, "'scenario' and a number of lines", "“scenario”及行数");
  }
  for (int i = 0; i < *scenario_lines; ++i) {
    line = reader.Next();
    if (!line.starts_with(kScenarioPrefix)) {
      return BadLine(reader, "a scenario line after '| '", "以“| ”开头的场景行");
    }
    schedule.scenario += line.substr(kScenarioPrefix.size());
    schedule.scenario += '\n';
  }

  int64_t total = 0;
  while (!reader.AtEnd()) {
    line = reader.Next();
    const std::string_view keyword = TakeWord(line);
    if (keyword == "run") {
      const auto thread = ReadWhole<int>(TakeWord(line));
      const auto statements = ReadWhole<int64_t>(line);
      if (!thread || *thread < 0 || *thread >= kThreadCount || !statements || *statements < 1 ||
          *statements > INT64_MAX - total) {
        return BadLine(reader, "'run', a thread 0 to 31 and a number of statements",
                       "“run”、线程号 0 至 31 及语句数");
      }
      schedule.segments.push_back({static_cast<uint8_t>(*thread), *statements});
      total += *statements;
    } else if (keyword == "next") {
      const auto source_line = ReadWhole<int>(TakeWord(line));
      const auto passes = ReadWhole<int64_t>(TakeWord(line));
      const bool expected = schedule.stops.size() + 1 == schedule.segments.size();
      if (!expected || !source_line || *source_line < 0 || !passes || *passes < 0) {
        return BadLine(reader,
                       "'next' after each 'run' or none, a line and how often it is reached",
                       "每个“run”之后均有或均无的“next”、行号及到达次数");
      }
      schedule.stops.push_back({*source_line, *passes, std::string(line)});
    } else if (keyword == "check") {
      const auto statement = ReadWhole<int64_t>(TakeWord(line));
      const auto hash = ReadWhole<uint64_t>(line, 16);
      const int64_t previous =
          schedule.checkpoints.empty() ? 0 : schedule.checkpoints.back().statement;
      if (!statement || *statement <= previous || *statement > total || !hash) {
        return BadLine(reader, "'check', a statement number already reached and a hash",
                       "“check”、已执行到的语句序号及散列值");
      }
      schedule.checkpoints.push_back({*statement, *hash});
    } else if (keyword == "cut") {
      const auto cut_us = ReadWhole<int64_t>(line);
      if (schedule.cut_us || !cut_us || *cut_us < 0) {
        return BadLine(reader, "one 'cut' and a time in us", "一个“cut”及以 us 计的时刻");
      }
      schedule.cut_us = cut_us;
    } else if (keyword == "end") {
      if (ReadWhole<int64_t>(line) != total || !reader.AtEnd()) {
        return BadLine(reader, fmt::format("'end {}' as the last line", total),
                       fmt::format("最后一行“end {}”", total));
      }
      if (!schedule.stops.empty() && schedule.stops.size() != schedule.segments.size()) {
        return BadLine(reader, "'next' after each 'run' or none",
                       "每个“run”之后均有或均无的“next”");
      }
      return schedule;
    } else {
      return BadLine(reader, "'run', 'check', 'cut' or 'end'", "“run”、“check”、“cut”或“end”");
    }
  }
  return BadLine(reader, "'end': the file is truncated", "“end”：文件不完整");
}

Result<Schedule> ParseScheduleFile(const std::string& path, std::string_view text) {
  auto schedule = ParseSchedule(text);
  if (schedule.ok()) return schedule;
  const Message& message = schedule.error().message;
  return MakeError(1, "{0}: {1}", "{0}：{2}", path, message.en, message.zh);
}

Result<Schedule> LoadSchedule(const std::string& path) {
  const auto text = ReadFile(path, kScheduleKind);
  if (!text.ok()) return text.error();
  return ParseScheduleFile(path, text.value());
}

}  // namespace oncard::vm
