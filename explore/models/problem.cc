#include "explore/models/problem.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "base/trim.h"
#include "compiler/dialect.h"
#include "runtime/scenario/file/placed_errors.h"
#include "runtime/scenario/file/search_names.h"
#include "runtime/scenario/run/assert_watch.h"

namespace oncard::explore {
namespace {

/// Calls `visit` with every part of a comma-separated list.
template <typename Visit>
void ForEachPart(std::string_view text, Visit visit) {
  while (!text.empty()) {
    const size_t comma = text.find(',');
    visit(Trim(text.substr(0, comma)));
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
}

bool IsHangRule(std::string_view name) {
  return std::ranges::find(runtime::kHangRuleNames, name) != runtime::kHangRuleNames.end();
}

/// Reads the explorer's comments of a source, one after the other.
class CommentReader {
 public:
  CommentReader(const std::string& path, std::string_view source)
      : file_(std::make_shared<const runtime::TextFile>(path, source)) {
    problem_.scenario.path = path;
    problem_.scenario.program = runtime::PathToScenario(problem_.scenario, path);
  }

  /// Reads the comment of a line.
  void Read(int number, std::string_view line) {
    number_ = number;
    line_ = line;
    const std::string_view comment = Trim(line).substr(compiler::kToolComment.size());
    const size_t colon = comment.find(':');
    const std::string_view key = Trim(comment.substr(0, colon));
    const std::string_view rest =
        colon == std::string_view::npos ? std::string_view{} : Trim(comment.substr(colon + 1));
    if (key == "endless" && colon == std::string_view::npos) {
      problem_.scenario.endless = true;
    } else if (rest.empty() || !ReadValue(key, rest)) {
      Refuse(Trim(comment));
    }
  }

  Result<CommentProblem> Finish() {
    for (auto& [place, why] :
         runtime::ClashesWithEndless(problem_.scenario, problem_.requirements)) {
      errors_.Add(place, std::move(why));
    }
    if (auto failure = errors_.Failure()) return *std::move(failure);
    return std::move(problem_);
  }

 private:
  /// False for a value that is not valid for the key.
  bool ReadValue(std::string_view key, std::string_view rest) {
    if (key == "init") {
      ForEachPart(rest, [this](std::string_view part) {
        AddValue(part, runtime::ParseInitialValue(part));
      });
    } else if (key == "input") {
      ForEachPart(
          rest, [this](std::string_view part) { AddValue(part, runtime::ParseValueRange(part)); });
    } else if (key == "sync") {
      ForEachPart(rest, [this](std::string_view part) { ReadSync(part); });
      problem_.of_all_schedules.push_back({"//@ sync", PlaceOfComment()});
    } else if (key == "races" && RaceRuleNamed(rest)) {
      problem_.scenario.races = rest;
      problem_.scenario.text_places["races"] = {PlaceOf(rest)};
      if (rest != runtime::Scenario{}.races) {
        problem_.of_all_schedules.push_back({"//@ races", PlaceOfComment()});
      }
    } else if (key == "livelock" && IsHangRule(rest)) {
      problem_.scenario.livelock = rest;
    } else if (key == "deadlock" && IsHangRule(rest)) {
      problem_.scenario.deadlock = rest;
    } else if (key.starts_with(kWithin)) {
      ReadWithin(key, rest);
    } else if (const auto scope = runtime::ScopeNamed(key)) {
      problem_.requirements.push_back(scope == Scope::kLeads
                                          ? ReadSides(*scope, rest)
                                          : Requirement{*scope, std::string(rest), PlaceOf(rest)});
    } else {
      return false;
    }
    return true;
  }

  /// Reads `p -> q`.
  Requirement ReadSides(Scope scope, std::string_view text) const {
    return runtime::ReadResponse(
        scope, text, [&](std::string_view side) { return PlaceOf(side.empty() ? text : side); });
  }

  /// Reads `within 5 ms` and `p -> q`.
  void ReadWithin(std::string_view key, std::string_view rest) {
    const auto us = runtime::ParseTime(Trim(key.substr(kWithin.size())));
    if (!us) {
      return errors_.Add(
          PlaceOf(key), MakeMessage("'{0}' needs a time of 0 to 1e9 ms, as in '//@ within 5 ms: "
                                    "gpi[1] == 1 -> axis1.moving == 0'",
                                    "“{0}”应带 0 至 1e9 ms 的时间，如“//@ within 5 ms: gpi[1] == 1 "
                                    "-> axis1.moving == 0”",
                                    key));
    }
    Requirement requirement = ReadSides(Scope::kWithin, rest);
    requirement.within_us = *us;
    requirement.time_place = PlaceOf(key);
    problem_.requirements.push_back(std::move(requirement));
  }

  /// A value that was read from a part of the line.
  void AddValue(std::string_view part, Result<runtime::InitialValue> value) {
    if (!value.ok()) return errors_.Add(PlaceOfComment(), value.error().message);
    value.value().place = PlaceOf(part);
    problem_.scenario.globals.push_back(std::move(value).value());
  }

  void ReadSync(std::string_view name) {
    problem_.scenario.sync.emplace_back(name);
    problem_.scenario.text_places["sync"].push_back(PlaceOf(name));
  }

  void Refuse(std::string_view comment) {
    errors_.Add(
        PlaceOfComment(),
        MakeMessage(
            "'{0}' is not a comment of the explorer: expected //@ init: v=1, //@ input: v = 0..3, "
            "//@ final:, //@ always:, //@ never: or //@ eventually: with an expression, "
            "//@ leads: or //@ within 5 ms: with 'p -> q', //@ sync: v, //@ races: none or benign, "
            "//@ endless, //@ livelock: any, or //@ deadlock: any",
            "“{0}”不是探索注释：应为 //@ init: v=1，//@ input: v = 0..3，//@ final:、//@ always:、"
            "//@ never: 或 //@ eventually: 加表达式，//@ leads: 或 //@ within 5 ms: 加“p -> q”，"
            "//@ sync: v，//@ races: none 或 benign，//@ endless，//@ livelock: any，或 "
            "//@ deadlock: any",
            comment));
  }

  /// The place of a part of the line.
  runtime::TextPlace PlaceOf(std::string_view part) const {
    const auto begin = static_cast<size_t>(part.data() - line_.data());
    return {file_, number_, static_cast<int>(begin) + 1, begin, begin + part.size()};
  }
  runtime::TextPlace PlaceOfComment() const { return PlaceOf(Trim(line_)); }

  static constexpr std::string_view kWithin = "within";

  std::shared_ptr<const runtime::TextFile> file_;
  int number_ = 0;
  std::string_view line_;
  CommentProblem problem_;
  runtime::PlacedErrors errors_;
};

void BindGuard(const Requirement& requirement, const Model& model, BoundRequirement* bound) {
  auto guard = runtime::GuardOf(requirement);
  if (!guard) return;
  auto matters = Property::Bind(guard->matters, model);
  if (!matters.ok()) return;
  bound->guard = std::move(guard);
  bound->matters = std::move(matters).value();
  bound->mattered = std::make_shared<std::atomic<bool>>(false);
}

/// Notes where the right side of a requirement matters.
void LookForGuard(const BoundRequirement& bound, const Model& state) {
  if (!bound.matters || bound.mattered->load(std::memory_order_relaxed)) return;
  if (bound.matters->Holds(state)) bound.mattered->store(true, std::memory_order_relaxed);
}

/// Lets the threads that execute a function check an assert of it, which is the requirement with
/// this number. `bound` gets the condition, and its `reached` is set when one of them checks it.
Result<void> AddAssert(const vm::Assert& assert, size_t function, int requirement,
                       BoundRequirement* bound, Model* model) {
  auto condition = runtime::ParseCondition(assert.condition);
  if (!condition.ok()) return condition.error();
  bound->property = Property::Of(condition.value());
  for (int thread = 0; thread < model->thread_count(); ++thread) {
    if (model->setup(thread).function != static_cast<int>(function)) continue;
    auto property = Property::BindInThread(condition.value(), thread, *model);
    if (!property.ok()) return property.error();
    StatementCheck check = property.value().AsCheck(requirement, thread, *model);
    check.holds = [holds = std::move(check.holds), reached = bound->reached](const Model& state) {
      if (!reached->load(std::memory_order_relaxed)) {
        reached->store(true, std::memory_order_relaxed);
      }
      return holds(state);
    };
    model->CheckBefore(thread, assert.position, std::move(check));
  }
  return {};
}

bool HasFunction(const vm::Object& object, const std::string& name) {
  for (const vm::Function& function : object.functions) {
    if (function.name == name) return true;
  }
  return false;
}

}  // namespace

Result<CommentProblem> ReadComments(const std::string& path, std::string_view source,
                                    const vm::Object& object) {
  CommentProblem problem;
  for (int thread = 0; thread < vm::kThreadCount; ++thread) {
    runtime::ThreadStart start;
    start.thread = thread;
    start.page = thread;
    start.function = fmt::format("t{}", thread);
    if (!HasFunction(object, start.function)) break;
    problem.scenario.threads.push_back(std::move(start));
  }
  if (problem.scenario.threads.empty()) {
    return MakeError(
        1,
        "{0} has no function t0: name the threads' functions t0, t1, ..., or explore a "
        "scenario that binds them",
        "{0} 中没有函数 t0：请将各线程的函数命名为 t0、t1……，或改用绑定线程的场景文件", path);
  }
  auto comments = ReadCommentLines(path, source);
  if (!comments.ok()) return comments;
  comments.value().scenario.threads = std::move(problem.scenario.threads);
  return comments;
}

Result<CommentProblem> ReadCommentLines(const std::string& path, std::string_view source) {
  CommentReader reader(path, source);
  compiler::ForEachToolComment(
      source, [&](int number, std::string_view line) { reader.Read(number, line); });
  return reader.Finish();
}

int FirstCommentLine(std::string_view source) {
  int first = 0;
  compiler::ForEachToolComment(source, [&](int number, std::string_view) {
    if (first == 0) first = number;
  });
  return first;
}

Requirement BoundRequirement::AsRequirement() const {
  Requirement requirement = {scope, property.text()};
  requirement.at = at;
  if (then) requirement.then = then->text();
  return requirement;
}

int FirstAssertLine(std::string_view source) {
  int first = 0;
  compiler::ForEachCommentLine(source, [&](int number, std::string_view line) {
    if (first == 0 && compiler::AssertConditionOf(line)) first = number;
  });
  return first;
}

bool Problem::HasInvariants() const {
  return std::ranges::any_of(requirements, [](const BoundRequirement& requirement) {
    return requirement.scope != Scope::kFinal && requirement.scope != Scope::kAssert;
  });
}

Problem BindProblem(Model model, const std::vector<Requirement>& requirements,
                    runtime::ScenarioErrors* errors) {
  Problem problem{std::move(model)};
  auto properties = runtime::ReadRequirements<Property>(requirements, problem.model, errors);
  if (properties.size() < requirements.size()) return problem;
  int eventually = 0;
  for (size_t i = 0; i < requirements.size(); ++i) {
    const int before = eventually;
    if (requirements[i].scope == Scope::kEventually) eventually += 1;
    if (requirements[i].scope == Scope::kLeads) eventually += 2;
    if (before <= kEventuallyMax && eventually > kEventuallyMax) {
      errors->Add(requirements[i].place,
                  requirements[i].scope == Scope::kEventually
                      ? MakeMessage("there are more than {0} 'eventually' expressions",
                                    "“eventually”表达式超过 {0} 个", kEventuallyMax)
                      : MakeMessage("there are too many 'eventually' and 'leads' expressions: at "
                                    "most {0}, where each 'leads' counts as two",
                                    "“eventually”与“leads”表达式过多：最多 {0} 个，其中每个“leads”"
                                    "计为两个",
                                    kEventuallyMax));
    }
    problem.requirements.push_back(
        {requirements[i].scope, std::move(properties[i].condition), std::move(properties[i].then)});
    BindGuard(requirements[i], problem.model, &problem.requirements.back());
  }
  return problem;
}

void AddAsserts(const std::string& program_path, Problem* problem,
                runtime::ScenarioErrors* errors) {
  const vm::Object& object = problem->model.image().object;
  const std::vector<Requirement> asserts = runtime::AssertsOf(object, program_path);
  size_t number = 0;
  for (size_t function = 0; function < object.functions.size(); ++function) {
    for (const vm::Assert& assert : object.functions[function].asserts) {
      const Requirement& written = asserts[number++];
      BoundRequirement bound = {.scope = Scope::kAssert,
                                .at = written.at,
                                .reached = std::make_shared<std::atomic<bool>>(false)};
      const auto requirement = static_cast<int>(problem->requirements.size());
      const auto added = AddAssert(assert, function, requirement, &bound, &problem->model);
      if (!added.ok()) {
        errors->AddText({}, fmt::format("{}: {}", written.at, written.Title()),
                        added.error().message);
      }
      problem->requirements.push_back(std::move(bound));
    }
  }
}

Model ModelOfTraces(const Problem& problem) {
  Model model = problem.model;
  for (size_t i = 0; i < problem.requirements.size(); ++i) {
    const BoundRequirement& bound = problem.requirements[i];
    if (bound.scope != Scope::kAlways && bound.scope != Scope::kNever) continue;
    StatementCheck check = bound.property.AsCheck(static_cast<int>(i), -1, model);
    check.holds = [bound](const Model& state) {
      LookForGuard(bound, state);
      return bound.property.Holds(state) == (bound.scope == Scope::kAlways);
    };
    model.CheckAfterWrites(check);
  }
  return model;
}

bool CanSearchTraces(const Problem& problem) {
  const auto sees_runs = [](const BoundRequirement& bound) {
    return bound.scope == Scope::kEventually || bound.scope == Scope::kLeads;
  };
  return std::ranges::none_of(problem.requirements, sees_runs) &&
         ModelOfTraces(problem).ChecksAreLocal();
}

std::vector<Message> UntestedOf(const Problem& problem) {
  std::vector<Message> texts;
  for (const BoundRequirement& bound : problem.requirements) {
    const Requirement requirement = bound.AsRequirement();
    if (bound.reached && !bound.reached->load()) {
      texts.push_back(runtime::DescribeUntestedAssert(requirement));
    }
    if (!bound.matters || bound.mattered->load()) continue;
    texts.push_back(runtime::DescribeVacuous(requirement, *bound.guard));
  }
  return texts;
}

std::optional<RaceRule> RaceRuleNamed(std::string_view name) {
  static_assert(runtime::kRaceRuleNames.size() == static_cast<size_t>(RaceRule::kNone) + 1);
  const auto found = std::ranges::find(runtime::kRaceRuleNames, name);
  if (found == runtime::kRaceRuleNames.end()) return std::nullopt;
  return static_cast<RaceRule>(found - runtime::kRaceRuleNames.begin());
}

Fault FindFault(const Problem& problem, const Model& state) {
  for (int thread = 0; thread < state.thread_count(); ++thread) {
    if (state.End(thread) == ThreadEnd::kCheckFailed) {
      return {Fault::Kind::kRequirement, state.FailedCheck(thread), thread};
    }
    if (Fails(state.End(thread))) return {Fault::Kind::kThread, 0, thread};
  }
  for (size_t i = 0; i < problem.requirements.size(); ++i) {
    const BoundRequirement& requirement = problem.requirements[i];
    if (requirement.scope == Scope::kEventually || requirement.scope == Scope::kAssert) continue;
    if (requirement.scope == Scope::kFinal && state.runnable() != 0) continue;
    LookForGuard(requirement, state);
    if (requirement.then) continue;
    if (requirement.property.Holds(state) == (requirement.scope == Scope::kNever)) {
      return {Fault::Kind::kRequirement, static_cast<int>(i), 0};
    }
  }
  return {};
}

}  // namespace oncard::explore
