#include "session/line_writes.h"

#include <algorithm>
#include <array>

#include "runtime/observe/step_log.h"
#include "runtime/observe/thread_status.h"

namespace oncard::session {
namespace {

bool Returns(const runtime::LoggedStep& step, const vm::Object& object) {
  const vm::Function& function = object.functions[static_cast<size_t>(step.function)];
  return function.instructions[static_cast<size_t>(step.position)].opcode == vm::Opcode::kReturn;
}

class Lines {
 public:
  /// A statement that the run has executed as the last one, at the moment before it.
  void Add(const runtime::LoggedStep& step, const RewindableRun& run) {
    const vm::Object& object = run.image().object;
    LineWrites& line = LineOf(step, object.functions[static_cast<size_t>(step.function)].file);
    line.moment = run.moment() - 1;
    for (const runtime::SlotChange& write : step.writes) {
      const std::string name = runtime::NameOf(step, write.slot, object);
      if (name.empty()) continue;
      const auto same = [&](const LineWrites::Value& value) { return value.name == name; };
      std::erase_if(line.values, same);
      line.values.push_back({name, runtime::ValueText(step, write.slot, write.after, object)});
    }
    const vm::ThreadState& thread = run.machine().thread(step.thread);
    if (Returns(step, object) && thread.run == vm::ThreadRun::kStopped &&
        thread.result_type != vm::DataType::kVoid) {
      line.result = runtime::ResultText(thread);
    }
  }

  void Clear() {
    lines_.clear();
    lines_of_threads_.fill(0);
  }

  std::vector<LineWrites> Take() {
    std::ranges::sort(lines_, {}, &LineWrites::moment);
    return std::move(lines_);
  }

 private:
  /// The entry of the line in which a statement stands; without what it wrote before if its thread
  /// comes from another line.
  LineWrites& LineOf(const runtime::LoggedStep& step, const std::string& file) {
    const auto is_of_step = [&](const LineWrites& line) {
      return line.thread == step.thread && line.line == step.line && line.file == file;
    };
    auto found = std::ranges::find_if(lines_, is_of_step);
    if (found == lines_.end()) found = lines_.insert(lines_.end(), LineWrites{});
    int& line_of_thread = lines_of_threads_[static_cast<size_t>(step.thread)];
    if (line_of_thread != step.line) *found = {step.thread, file, step.line, 0, {}, {}};
    line_of_thread = step.line;
    return *found;
  }

  std::vector<LineWrites> lines_;
  /// The line in which each thread has executed a statement last; 0: none.
  std::array<int, vm::kThreadCount> lines_of_threads_{};
};

/// Goes back to a kept moment before which no more than `executed` statements had been executed, or
/// as far back as is looked at.
void GoBack(RewindableRun& run, int64_t executed) {
  const int64_t first = std::max<int64_t>(0, run.moment() - kWritesMomentsMax);
  while (run.moment() > first && run.machine().state().executed > executed) {
    run.GoTo(std::max(first, run.KeptBefore(run.moment())));
  }
}

}  // namespace

std::vector<LineWrites> WritesOfLines(RewindableRun& run, int64_t statements) {
  const int64_t present = run.moment();
  const int64_t skipped = run.machine().state().executed - statements;
  Lines lines;
  runtime::StepWatch watch(run.controller());
  GoBack(run, skipped);
  const vm::Image* program = run.machine().image();
  while (run.moment() < present && !run.EndIsWanted()) {
    const bool is_shown =
        run.NextStep() == StepKind::kStatement && run.machine().state().executed >= skipped;
    if (is_shown) watch.Before();
    const StepReport& step = run.Step();
    if (is_shown) lines.Add(watch.After(step.thread), run);
    if (run.machine().image() != program) lines.Clear();
    program = run.machine().image();
  }
  run.GoTo(present);
  return lines.Take();
}

}  // namespace oncard::session
