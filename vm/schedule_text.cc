#include "vm/schedule_text.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>
#include <utility>

namespace oncard::vm {
namespace {

void AppendNumber(std::string& text, int64_t number) {
  char digits[20];
  const auto end = std::to_chars(std::begin(digits), std::end(digits), number).ptr;
  text.append(std::begin(digits), end);
}

// A long recording has millions of these lines, so they are put together without fmt.
void AppendRun(std::string& text, const ScheduleSegment& segment) {
  text += "run ";
  AppendNumber(text, segment.thread);
  text += ' ';
  AppendNumber(text, segment.statements);
  text += '\n';
}

}  // namespace

std::string LineOf(const ScheduleSegment& segment) {
  std::string line;
  AppendRun(line, segment);
  return line;
}

ScheduleText::ScheduleText(uint64_t program_hash, std::string_view scenario,
                           std::span<const ScheduleCheckpoint> checkpoints)
    : text_(fmt::format("{}\nprogram {:016x}\n", kFirstLine, program_hash)),
      checkpoints_(checkpoints) {
  std::string lines;
  int line_count = 0;
  for (LineReader reader(scenario); !reader.AtEnd(); ++line_count) {
    lines += fmt::format("{}{}\n", kScenarioPrefix, reader.Next());
  }
  text_ += fmt::format("scenario {}\n{}", line_count, lines);
}

void ScheduleText::AddRun(const ScheduleSegment& segment) {
  AppendRun(text_, segment);
  total_ += segment.statements;
}

void ScheduleText::AddNext(const ScheduleStop& stop) {
  text_ += fmt::format("next {} {}{}{}\n", stop.line, stop.passes, stop.text.empty() ? "" : " ",
                       stop.text);
}

void ScheduleText::AddChecks() {
  for (; UntilCheck() <= 0; checkpoints_ = checkpoints_.subspan(1)) {
    text_ += fmt::format("check {} {:016x}\n", checkpoints_.front().statement,
                         checkpoints_.front().hash);
  }
}

std::string ScheduleText::Finish(const std::optional<int64_t>& cut_us) {
  if (cut_us) text_ += fmt::format("cut {}\n", *cut_us);
  text_ += fmt::format("end {}\n", total_);
  return std::move(text_);
}

}  // namespace oncard::vm
