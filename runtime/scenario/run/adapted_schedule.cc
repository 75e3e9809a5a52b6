#include "runtime/scenario/run/adapted_schedule.h"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "base/trim.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"

namespace oncard::runtime {
namespace {

/// The lines of a source without leading and trailing white space; element 0 is unused.
std::vector<std::string> TrimmedLines(std::string_view source) {
  std::vector<std::string> lines(1);
  while (!source.empty()) {
    const size_t end = std::min(source.find('\n'), source.size());
    const std::string_view line = source.substr(0, end);
    source.remove_prefix(std::min(end + 1, source.size()));
    lines.emplace_back(Trim(line));
  }
  return lines;
}

/// A card whose threads are stepped statement by statement, as in a replay.
class StatementRun {
 public:
  StatementRun(const Scenario& scenario, std::string_view source)
      : scenario_(scenario), lines_(TrimmedLines(source)), controller_(CardOptions(scenario)) {}

  Result<void> Start(vm::Object object) {
    return StartScenario(scenario_, std::move(object), &controller_);
  }
  const vm::Machine& machine() const { return controller_.machine(); }

  /// The threads that can execute the next statement; 0 at the end of the run.
  uint32_t Runnable() {
    vm::Machine& machine = controller_.machine();
    const int64_t last = controller_.clock().CycleAt(scenario_.limit_ms * 1000);
    while (!machine.Quiet() && !controller_.Deadlocked() && controller_.cycle() < last) {
      if (left_ > 0 && machine.RunnableThreads() != 0) return machine.RunnableThreads();
      left_ = controller_.BeginCycle();
      machine.Execute(0);
    }
    return 0;
  }
  /// Executes one statement of a thread that Runnable() contains.
  void Step(int thread) {
    controller_.machine().ExecuteOne(thread);
    controller_.machine().Execute(0);
    --left_;
    if (segments_.empty() || segments_.back().thread != thread) {
      segments_.push_back({static_cast<uint8_t>(thread), 0});
    }
    ++segments_.back().statements;
  }
  /// The line of a thread's next statement; 0 when it has ended.
  int Line(int thread) const {
    return machine().thread(thread).run == vm::ThreadRun::kRunning ? machine().Line(thread) : 0;
  }
  const std::string& Text(int line) const {
    return lines_[static_cast<size_t>(line) < lines_.size() ? static_cast<size_t>(line) : 0];
  }
  const std::vector<vm::ScheduleSegment>& segments() const { return segments_; }

 private:
  const Scenario& scenario_;
  std::vector<std::string> lines_;
  Controller controller_;
  int64_t left_ = 0;
  std::vector<vm::ScheduleSegment> segments_;
};

bool CanStep(uint32_t runnable, int thread) { return (runnable >> thread & 1) != 0; }

/// Runs a thread until it has reached `stop` as often as that says. False if it does not.
bool FollowTo(const vm::ScheduleStop& stop, int thread, StatementRun* run) {
  int64_t passes = 0;
  while (CanStep(run->Runnable(), thread)) {
    run->Step(thread);
    const int line = run->Line(thread);
    if (line == 0) return stop.line == 0;
    if (stop.line != 0 && run->Text(line) == stop.text && ++passes == stop.passes) return true;
  }
  return false;
}

Message DescribeDivergence(const vm::ScheduleStop& stop, int thread) {
  if (stop.line == 0) {
    return MakeMessage("thread {0} no longer ends here", "线程 {0} 在此处不再运行到结束", thread);
  }
  return MakeMessage("thread {0} no longer reaches '{1}' (line {2} of the old program)",
                     "线程 {0} 不再执行到“{1}”（原程序第 {2} 行）", thread, stop.text, stop.line);
}

}  // namespace

Result<void> AnnotateSchedule(const Scenario& scenario, vm::Object object, std::string_view source,
                              vm::Schedule* schedule) {
  StatementRun run(scenario, source);
  if (auto started = run.Start(std::move(object)); !started.ok()) return started.error();
  std::vector<vm::ScheduleStop> stops;
  for (const vm::ScheduleSegment& segment : schedule->segments) {
    std::vector<int> lines;  // the lines that the thread reached
    for (int64_t i = 0; i < segment.statements; ++i) {
      if (!CanStep(run.Runnable(), segment.thread)) {
        return MakeError(1, "the schedule belongs to another program", "该调度不属于此程序");
      }
      run.Step(segment.thread);
      lines.push_back(run.Line(segment.thread));
    }
    vm::ScheduleStop stop;
    stop.line = lines.back();
    stop.text = run.Text(stop.line);
    stop.passes = stop.line == 0 ? 0 : std::count_if(lines.begin(), lines.end(), [&](int line) {
      return run.Text(line) == stop.text;
    });
    stops.push_back(std::move(stop));
  }
  schedule->stops = std::move(stops);
  return {};
}

Result<AdaptedSchedule> AdaptSchedule(const Scenario& scenario, vm::Object object,
                                      std::string_view source, const vm::Schedule& old) {
  if (old.stops.size() != old.segments.size()) {
    return MakeError(1,
                     "the schedule does not say at which lines its threads stop; 'oncard explore "
                     "--save' writes such schedules",
                     "该调度未记录各线程停在哪些行；“oncard explore --save”会写出这样的调度");
  }
  if (!scenario.host.empty()) {
    return MakeError(1, "a scenario with host events can only be replayed strictly",
                     "带主机事件的场景只能严格重放");
  }
  StatementRun run(scenario, source);
  if (auto started = run.Start(std::move(object)); !started.ok()) return started.error();
  AdaptedSchedule adapted;
  for (size_t i = 0; i < old.segments.size() && !adapted.divergence; ++i) {
    const int thread = old.segments[i].thread;
    if (FollowTo(old.stops[i], thread, &run)) {
      ++adapted.followed;
    } else {
      adapted.divergence = DescribeDivergence(old.stops[i], thread);
    }
  }
  while (const uint32_t runnable = run.Runnable()) {
    const int last = run.segments().empty() ? 0 : run.segments().back().thread;
    run.Step(CanStep(runnable, last) ? last : std::countr_zero(runnable));
  }
  adapted.schedule.program_hash = run.machine().image()->hash;
  adapted.schedule.scenario = old.scenario;
  adapted.schedule.segments = run.segments();
  return adapted;
}

}  // namespace oncard::runtime
