#include "session/stops.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/milliseconds.h"
#include "runtime/observe/quantity.h"
#include "runtime/observe/thread_status.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/run/response.h"
#include "runtime/scenario/run/scenario_errors.h"
#include "runtime/scenario/run/scenario_start.h"

namespace oncard::session {
namespace {

using runtime::CardCondition;
using runtime::Quantity;

/// The texts and values of a log line, of which the values are in braces.
Result<std::vector<std::variant<std::string, Quantity>>> ReadLog(const std::string& log,
                                                                 const runtime::Controller& card) {
  std::vector<std::variant<std::string, Quantity>> parts;
  for (size_t at = 0; at < log.size();) {
    const size_t open = log.find('{', at);
    if (open != at) parts.emplace_back(log.substr(at, open - at));
    if (open == std::string::npos) break;
    const size_t close = log.find('}', open);
    if (close == std::string::npos) {
      return MakeError(1, "a brace in the log text '{0}' is not closed",
                       "日志文本“{0}”中的花括号未闭合", log);
    }
    auto found = runtime::ResolveQuantity(log.substr(open + 1, close - open - 1), card);
    if (!found.ok()) return found.error();
    for (Quantity& quantity : found.value()) parts.emplace_back(std::move(quantity));
    at = close + 1;
  }
  return parts;
}

uint32_t FreshThreads(const vm::Machine& machine) {
  uint32_t fresh = 0;
  for (int number = 0; number < vm::kThreadCount; ++number) {
    const vm::ThreadState& thread = machine.thread(number);
    if (thread.run == vm::ThreadRun::kRunning && thread.executed == 0) fresh |= 1u << number;
  }
  return fresh;
}

Message DoesNotHold(const std::string& title, const CardCondition& condition,
                    const RewindableRun& run) {
  const Message values = condition.DescribeValues(run.controller());
  return MakeMessage("{0} does not hold: {1}", "{0} 不成立：{2}", title, values.en, values.zh);
}

/// Why a response is not given.
Message DescribeOwed(const RewindableRun::Response& response, const runtime::Owed& owed,
                     const RewindableRun& run) {
  const auto at = [](double ms) { return MakeMessage("at {0} ms", "在 {0} ms ", ms); };
  const Message why = runtime::DescribeUnanswered(
      response.requirement, at(ToMs(owed.since_ns / runtime::CardClock::kNsPerUs)),
      at(run.controller().NowMs()), response.right.DescribeValues(run.controller()));
  return MakeMessage("{0} does not hold: {1}", "{0} 不成立：{2}", response.requirement.Title(),
                     why.en, why.zh);
}

/// The first line from `line` on that has a statement in the file; 0: there is none.
int LineWithStatement(const vm::Object& object, const std::string& file, int line) {
  int nearest = 0;
  for (const vm::Function& function : object.functions) {
    if (!file.empty() && function.file != file) continue;
    for (const int has : function.lines) {
      if (has >= line && (nearest == 0 || has < nearest)) nearest = has;
    }
  }
  return nearest;
}

/// True if a thread has been started with the beginning of this cycle and has not executed a
/// statement. Those of a scenario are started with the first one.
bool StartedNow(const vm::ThreadState& thread, int64_t cycle, bool of_scenario) {
  if (thread.run != vm::ThreadRun::kRunning || thread.executed != 0) return false;
  return (of_scenario && cycle == 1) ||
         (thread.period_cycles != 0 && thread.next_start - thread.period_cycles == cycle);
}

}  // namespace

// --- What to stop at -----------------------------------------------------------------------------

Result<Stops> Stops::Create(const RewindableRun& run) {
  Stops stops;
  runtime::ScenarioErrors errors;
  const auto requirements = runtime::RequirementsOf(run.scenario());
  runtime::CheckTimes(requirements, run.scenario(), run.image().object, &errors);
  auto conditions =
      runtime::ReadRequirements<CardCondition>(requirements, run.controller(), &errors);
  stops.asserts_ = runtime::AssertWatch(runtime::ProgramPath(run.scenario()));
  if (run.calls() == nullptr) stops.asserts_.Begin(run.controller(), &errors);
  if (auto failure = errors.Failure()) return *std::move(failure);
  for (size_t i = 0; i < requirements.size(); ++i) {
    const runtime::Scope scope = requirements[i].scope;
    if (auto& [condition, then] = conditions[i]; then) {
      stops.answers_.push_back({{requirements[i], std::move(condition), *std::move(then)}});
      continue;
    }
    auto& list = scope == runtime::Scope::kFinal        ? stops.final_
                 : scope == runtime::Scope::kEventually ? stops.eventually_
                                                        : stops.requirements_;
    list.push_back({std::move(conditions[i].condition), scope == runtime::Scope::kNever, false, -1,
                    requirements[i].Title()});
  }
  return stops;
}

Result<Stops::Line> Stops::ReadLine(const LineStop& wish, const runtime::Controller& card) {
  static const vm::Image none;
  const vm::Image* const program = card.machine().image();
  const vm::Image& image = program == nullptr ? none : *program;
  Line line;
  line.asked = wish;
  line.wish = wish;
  if (wish.function) {
    const auto function = runtime::FunctionIndex(*wish.function, image);
    if (!function.ok()) return function.error();
    line.function = static_cast<size_t>(function.value());
    const auto& lines = image.object.functions[line.function].lines;
    const auto position = static_cast<size_t>(wish.position);
    if (position >= lines.size()) {
      return MakeError(1, "{0} has no statement at position {1}: it has {2} statements, from 0 on",
                       "{0} 中没有位置为 {1} 的语句：共 {2} 条，自 0 起", *wish.function,
                       wish.position, lines.size());
    }
    line.wish.line = lines[position];
  } else {
    line.wish.line = LineWithStatement(image.object, wish.file, wish.line);
  }
  if (line.wish.line == 0) {
    return MakeError(1, "no statement of {0} is on line {1} or after it",
                     "{0} 的第 {1} 行及其后没有语句",
                     wish.file.empty() ? std::string("the program") : wish.file, wish.line);
  }
  if (!wish.condition.empty()) {
    auto condition = CardCondition::Read(wish.condition, card);
    if (!condition.ok()) return condition.error();
    line.condition = std::move(condition).value();
  }
  auto log = ReadLog(wish.log, card);
  if (!log.ok()) return log.error();
  line.log = std::move(log).value();
  return line;
}

Result<void> Stops::Set(const StopWishes& wishes, const RewindableRun& run) {
  Stops stops;
  stops.wishes_ = wishes;
  for (const LineStop& wish : wishes.lines) {
    Line& line = stops.lines_.emplace_back();
    line.asked = line.wish = wish;
  }
  auto refused = stops.Bind(run.controller());
  if (run.calls() != nullptr) {
    for (const auto& program : run.calls()->programs()) {
      Stops there = stops;
      const auto refused_there = there.Bind(run.CardWith(program));
      for (size_t i = 0; i < refused.size(); ++i) {
        if (!refused[i] || refused_there[i]) continue;
        refused[i].reset();
        if (i < stops.lines_.size()) stops.lines_[i].wish = there.lines_[i].wish;
      }
    }
  }
  for (auto& why : refused) {
    if (why) return *std::move(why);
  }
  stops.faults_ = wishes.faults;
  stops.refusals_ = wishes.refusals;
  stops.checks_requirements_ = wishes.requirements;
  stops.races_ = wishes.races;
  stops.warnings_ = wishes.warnings;
  stops.requirements_ = std::move(requirements_);
  stops.final_ = std::move(final_);
  stops.eventually_ = std::move(eventually_);
  stops.answers_ = std::move(answers_);
  stops.asserts_ = std::move(asserts_);
  // A line that was there before keeps its count.
  for (Line& line : stops.lines_) {
    const auto same = [&](const Line& old) {
      return old.wish.file == line.wish.file && old.wish.line == line.wish.line &&
             old.wish.function == line.wish.function && old.wish.position == line.wish.position &&
             old.wish.thread == line.wish.thread && old.wish.condition == line.wish.condition;
    };
    const auto old = std::ranges::find_if(lines_, same);
    if (old != lines_.end()) line.hits = std::move(old->hits);
  }
  *this = std::move(stops);
  return {};
}

std::vector<std::optional<Error>> Stops::Bind(const runtime::Controller& card) {
  bound_ = card.machine().image();
  std::vector<std::optional<Error>> refused;
  // Notes whether a result is good.
  const auto good = [&refused](const auto& result) {
    refused.push_back(result.ok() ? std::nullopt : std::optional(result.error()));
    return result.ok();
  };
  for (Line& line : lines_) {
    auto read = ReadLine(line.asked, card);
    line.rests = !good(read);
    if (line.rests) continue;
    read.value().hits = std::move(line.hits);
    line = std::move(read).value();
  }
  values_.clear();
  for (size_t i = 0; i < wishes_.changes.size(); ++i) {
    auto found = runtime::ResolveQuantity(wishes_.changes[i], card);
    if (!good(found)) continue;
    for (Quantity& quantity : found.value()) {
      values_.push_back({std::move(quantity), 0, static_cast<int>(i)});
    }
  }
  conditions_.clear();
  for (size_t i = 0; i < wishes_.conditions.size(); ++i) {
    auto condition = CardCondition::Read(wishes_.conditions[i], card);
    if (!good(condition)) continue;
    conditions_.push_back(
        {std::move(condition).value(), true, false, static_cast<int>(i), wishes_.conditions[i]});
  }
  return refused;
}

std::vector<int> Stops::lines() const {
  std::vector<int> lines;
  for (const Line& line : lines_) lines.push_back(line.wish.line);
  return lines;
}

bool Stops::CheckEveryStep() const {
  return !lines_.empty() || !wishes_.changes.empty() || !wishes_.conditions.empty() || races_ ||
         (checks_requirements_ &&
          (!requirements_.empty() || !answers_.empty() || !asserts_.empty()));
}

std::vector<Message> Stops::FailedAtEnd(const RewindableRun& run) const {
  std::vector<Message> failed;
  if (const auto* calls = run.calls(); calls != nullptr) {
    if (auto why = calls->Incomplete()) failed.push_back(*std::move(why));
  }
  if (run.is_cut()) return failed;
  const auto check = [&](const std::string& title, const CardCondition& condition) {
    if (condition.Holds(run.controller())) return;
    failed.push_back(DoesNotHold(title, condition, run));
  };
  for (const runtime::Agenda::Check& each : run.expectations_at_end()) {
    check(each.text, each.condition);
  }
  for (const Truth& each : final_) check(each.title, each.condition);
  for (size_t i = 0; i < eventually_.size(); ++i) {
    if (run.HasHeld(i)) continue;
    const Message values = eventually_[i].condition.DescribeValues(run.controller());
    failed.push_back(MakeMessage("{0} held in no state of the run; at its end {1}",
                                 "{0} 在整个运行中从未成立；结束时 {2}", eventually_[i].title,
                                 values.en, values.zh));
  }
  for (size_t i = 0; i < answers_.size(); ++i) {
    const runtime::Requirement& requirement = answers_[i].response.requirement;
    if (requirement.scope != runtime::Scope::kLeads || !run.OwedTo(i).pending) continue;
    failed.push_back(DescribeOwed(answers_[i].response, run.OwedTo(i), run));
  }
  return failed;
}

std::vector<RewindableRun::Response> Stops::Responses() const {
  std::vector<RewindableRun::Response> responses;
  for (const Answer& each : answers_) responses.push_back(each.response);
  return responses;
}

std::vector<CardCondition> Stops::Awaited() const {
  std::vector<CardCondition> conditions;
  for (const Truth& each : eventually_) conditions.push_back(each.condition);
  return conditions;
}

// --- Checks --------------------------------------------------------------------------------------

void Stops::Begin(const RewindableRun& run) {
  if (run.machine().image() != bound_) Bind(run.controller());
  const vm::Machine& machine = run.machine();
  fresh_ = FreshThreads(machine);
  const uint32_t runnable = machine.RunnableThreads();
  asleep_ = 0;
  at_lines_ = ~0u;
  reached_ = 0;
  arrivals_ = 0;
  for (int number = 0; number < vm::kThreadCount; ++number) {
    const vm::ThreadState& thread = machine.thread(number);
    pcs_[static_cast<size_t>(number)] = thread.pc;
    const bool sleeps = thread.run == vm::ThreadRun::kRunning && (runnable >> number & 1) == 0;
    if (sleeps && thread.executed > 0) asleep_ |= 1u << number;
  }
  for (Truth& truth : requirements_) truth.last = truth.condition.Holds(run.controller());
  for (size_t i = 0; i < answers_.size(); ++i) answers_[i].late = run.OwedTo(i).late;
  asserts_.Remember(run.controller());
  Remember(run);
  fault_count_ = machine.state().faults;
}

void Stops::Remember(const RewindableRun& run) {
  for (Value& value : values_) value.last = ReadQuantity(value.quantity, run.controller());
  for (Truth& truth : conditions_) truth.last = truth.condition.Holds(run.controller());
}

std::optional<Stop> Stops::Check(const RewindableRun& run, const StepReport& step,
                                 std::vector<LogLine>* log) {
  if (run.machine().image() != bound_) {
    // A host has downloaded another program, in which no thread runs yet.
    Bind(run.controller());
    Remember(run);
    asleep_ = fresh_ = 0;
    pcs_ = {};
  }
  FindArrivals(run, step);
  // Each of them updates what it remembers, so all are called.
  std::optional<Stop> incident = CheckIncidents(run, step);
  std::optional<Stop> failed = CheckAsserts(run);
  std::optional<Stop> truth = CheckTruths(run, step);
  std::optional<Stop> value = CheckValues(run, step);
  std::optional<Stop> line = CheckLines(run, log);
  if (incident) return incident;
  if (failed) return failed;
  if (truth) return truth;
  return value ? value : line;
}

// A thread arrives at every statement, and at a line when its next statement is the line's first,
// or when it comes from another line; a thread that sleeps arrives when it wakes up.
void Stops::FindArrivals(const RewindableRun& run, const StepReport& step) {
  const vm::Machine& machine = run.machine();
  reached_ = 0;
  const auto runnable = [&](int number) { return (machine.RunnableThreads() >> number & 1) != 0; };
  if (step.kind == StepKind::kStatement && step.thread >= 0) {
    const vm::ThreadState& thread = machine.thread(step.thread);
    const auto& lines = run.image().object.functions[thread.function].lines;
    uint16_t& was = pcs_[static_cast<size_t>(step.thread)];
    const bool runs = thread.run == vm::ThreadRun::kRunning && thread.pc < lines.size();
    const uint32_t bit = 1u << step.thread;
    fresh_ &= ~bit;
    if (runs) {
      const bool at_line = lines[thread.pc] != lines[was] || thread.pc <= was;
      at_lines_ = at_line ? at_lines_ | bit : at_lines_ & ~bit;
      (runnable(step.thread) ? reached_ : asleep_) |= bit;
    }
    was = thread.pc;
  }
  for (uint32_t rest = asleep_; rest != 0; rest &= rest - 1) {
    const int number = std::countr_zero(rest);
    const bool runs = machine.thread(number).run == vm::ThreadRun::kRunning;
    if (runs && !runnable(number)) continue;
    asleep_ &= ~(1u << number);
    if (runs) reached_ |= 1u << number;
  }
  for (int number = 0; step.kind == StepKind::kCycle && number < vm::kThreadCount; ++number) {
    const vm::ThreadState& thread = machine.thread(number);
    if (!StartedNow(thread, run.controller().cycle(), run.calls() == nullptr)) continue;
    pcs_[static_cast<size_t>(number)] = thread.pc;
    reached_ |= 1u << number;
    at_lines_ |= 1u << number;
    fresh_ |= 1u << number;
  }
  if (step.call) FindStarted(machine);
  arrivals_ = reached_ & at_lines_;
}

// Threads that a call of the host has started.
void Stops::FindStarted(const vm::Machine& machine) {
  const uint32_t fresh = FreshThreads(machine);
  const uint32_t started = fresh & ~fresh_;
  fresh_ = fresh;
  for (uint32_t rest = started; rest != 0; rest &= rest - 1) {
    const auto number = static_cast<size_t>(std::countr_zero(rest));
    pcs_[number] = machine.thread(static_cast<int>(number)).pc;
  }
  reached_ |= started;
  at_lines_ |= started;
}

std::optional<Stop> Stops::CheckLines(const RewindableRun& run, std::vector<LogLine>* log) {
  std::optional<Stop> stop;
  for (size_t i = 0; i < lines_.size(); ++i) {
    Line& line = lines_[i];
    if (line.rests) continue;
    const bool at_statement = line.wish.function.has_value();
    for (uint32_t rest = at_statement ? reached_ : arrivals_; rest != 0; rest &= rest - 1) {
      const int number = std::countr_zero(rest);
      const vm::ThreadState& thread = run.machine().thread(number);
      const vm::Function& function = run.image().object.functions[thread.function];
      if (at_statement) {
        if (thread.function != line.function || thread.pc != line.wish.position) continue;
      } else if (function.lines[thread.pc] != line.wish.line) {
        continue;
      }
      if (!line.wish.file.empty() && function.file != line.wish.file) continue;
      if (line.wish.thread && *line.wish.thread != number) continue;
      if (line.condition && !line.condition->Holds(run.controller())) continue;
      const auto known = std::ranges::lower_bound(line.hits, run.moment());
      const auto count = known - line.hits.begin() + 1;
      if (known == line.hits.end() || *known != run.moment()) {
        line.hits.insert(known, run.moment());
      }
      if (count < line.wish.hits) continue;
      if (line.wish.log.empty()) {
        if (!stop) stop = Stop{StopReason::kLine, number, static_cast<int>(i)};
        continue;
      }
      if (log == nullptr) continue;
      std::string text;
      for (const auto& part : line.log) {
        const auto* quantity = std::get_if<Quantity>(&part);
        text += quantity == nullptr ? std::get<std::string>(part)
                                    : runtime::FormatQuantity(*quantity, run.controller());
      }
      log->push_back({run.moment(), number, std::move(text)});
    }
  }
  return stop;
}

std::optional<Stop> Stops::CheckValues(const RewindableRun& run, const StepReport& step) {
  std::optional<Stop> stop;
  for (Value& value : values_) {
    const double now = ReadQuantity(value.quantity, run.controller());
    if (now == value.last) continue;
    if (!stop) {
      const auto form = FormOfQuantity(value.quantity, run.controller());
      const std::string was = runtime::FormatNumber(value.last, form);
      const std::string is = runtime::FormatNumber(now, form);
      stop = Stop{StopReason::kChange, step.thread, value.number,
                  MakeMessage("{0} has changed from {1} to {2}", "{0} 由 {1} 变为 {2}",
                              value.quantity.name, was, is)};
    }
    value.last = now;
  }
  return stop;
}

// The statement has been executed; what is said is about the state before it.
std::optional<Stop> Stops::CheckAsserts(const RewindableRun& run) {
  std::optional<Stop> stop;
  for (const runtime::FailedAssert& failed : asserts_.AfterStatements(run.controller())) {
    if (!checks_requirements_ || stop) continue;
    const runtime::Requirement& requirement = asserts_.asserts()[failed.number];
    const Message what = Describe(failed, requirement);
    stop = Stop{StopReason::kRequirement, failed.thread, -1,
                MakeMessage("{0} {1}", "{0} {2}", requirement.Title(), what.en, what.zh)};
  }
  return stop;
}

std::optional<Stop> Stops::CheckTruths(const RewindableRun& run, const StepReport& step) {
  std::optional<Stop> stop;
  const auto changes_to_wanted = [&](Truth& truth) {
    const bool now = truth.condition.Holds(run.controller());
    const bool turned = now != truth.last && now == truth.wanted;
    truth.last = now;
    return turned;
  };
  for (Truth& truth : requirements_) {
    if (!changes_to_wanted(truth) || !checks_requirements_ || stop) continue;
    stop = Stop{StopReason::kRequirement, step.thread, -1,
                DoesNotHold(truth.title, truth.condition, run)};
  }
  for (size_t i = 0; i < answers_.size(); ++i) {
    const bool was_late = std::exchange(answers_[i].late, run.OwedTo(i).late);
    if (was_late || !answers_[i].late || !checks_requirements_ || stop) continue;
    stop = Stop{StopReason::kRequirement, step.thread, -1,
                DescribeOwed(answers_[i].response, run.OwedTo(i), run)};
  }
  for (Truth& truth : conditions_) {
    if (!changes_to_wanted(truth) || stop) continue;
    stop = Stop{StopReason::kCondition, step.thread, truth.number,
                MakeMessage("{0} has become true", "{0} 已成立", truth.title)};
  }
  return stop;
}

std::optional<Stop> Stops::CheckIncidents(const RewindableRun& run, const StepReport& step) {
  if (step.deviation) return Stop{StopReason::kDeviation, -1, -1, *step.deviation};
  const int64_t faults_before = std::exchange(fault_count_, run.machine().state().faults);
  if (faults_ && fault_count_ != faults_before && step.thread >= 0) {
    return Stop{StopReason::kFault, step.thread, -1,
                runtime::DescribeFault(run.machine().thread(step.thread), run.image())};
  }
  if (refusals_ && step.refusal != nullptr) {
    return Stop{StopReason::kRefusal, step.refusal->thread, -1, step.refusal->call};
  }
  if (races_ && step.race) return Stop{StopReason::kRace, step.thread, -1, *step.race};
  if (checks_requirements_ && !step.failed.empty()) {
    return Stop{StopReason::kRequirement, -1, -1, step.failed.front()};
  }
  if (warnings_ && step.warning) {
    return Stop{StopReason::kWarning, step.thread, -1, *step.warning};
  }
  return std::nullopt;
}

}  // namespace oncard::session
