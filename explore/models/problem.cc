#include "explore/models/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "base/trim.h"
#include "runtime/scenario/placed_errors.h"

namespace oncard::explore {
namespace {

constexpr std::string_view kMark = "//@";

/// Calls `look` with the number and text of every line that is such a comment.
template <typename Look>
void ForEachComment(std::string_view source, Look look) {
  int number = 1;
  for (size_t begin = 0; begin < source.size(); ++number) {
    const size_t end = std::min(source.find('\n', begin), source.size());
    const std::string_view line = source.substr(begin, end - begin);
    begin = end + 1;
    if (Trim(line).starts_with(kMark)) look(number, line);
  }
}

std::optional<Scope> ScopeNamed(std::string_view name) {
  if (name == "final") return Scope::kFinal;
  if (name == "always") return Scope::kAlways;
  if (name == "never") return Scope::kNever;
  if (name == "eventually") return Scope::kEventually;
  return std::nullopt;
}

/// Reads `g=1, h=5`.
Result<void> ReadInitialValues(std::string_view text, runtime::Scenario* scenario) {
  while (!text.empty()) {
    const size_t comma = text.find(',');
    auto value = runtime::ParseInitialValue(Trim(text.substr(0, comma)));
    if (!value.ok()) return value.error();
    scenario->globals.push_back(std::move(value).value());
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  return {};
}

/// Reads `f, g`.
void ReadNames(std::string_view text, std::vector<std::string>* names) {
  while (!text.empty()) {
    const size_t comma = text.find(',');
    names->emplace_back(Trim(text.substr(0, comma)));
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
}

/// Where a part of a line stands.
runtime::TextPlace PlaceIn(std::shared_ptr<const runtime::TextFile> file, int number,
                           std::string_view line, std::string_view part) {
  const auto begin = static_cast<size_t>(part.data() - line.data());
  return {std::move(file), number, static_cast<int>(begin) + 1, begin, begin + part.size()};
}

/// Reads what follows the mark of a comment. A requirement's place is left to the caller, who knows
/// it from `*expression`.
Result<void> ReadComment(std::string_view comment, CommentProblem* problem,
                         std::string_view* expression) {
  const size_t colon = comment.find(':');
  const std::string_view key = Trim(comment.substr(0, colon));
  const std::string_view rest =
      colon == std::string_view::npos ? std::string_view{} : Trim(comment.substr(colon + 1));
  if (key == "init" && !rest.empty()) return ReadInitialValues(rest, &problem->scenario);
  if (key == "sync" && !rest.empty()) {
    ReadNames(rest, &problem->scenario.sync);
    return {};
  }
  if (key == "races" && RaceRuleNamed(rest)) {
    problem->scenario.races = rest;
    return {};
  }
  if (const auto scope = ScopeNamed(key); scope && !rest.empty()) {
    problem->requirements.push_back({*scope, std::string(rest)});
    *expression = rest;
    return {};
  }
  return MakeError(
      1,
      "'{0}' is not a comment of the explorer: expected //@ init: v=1, //@ final:, //@ always:, "
      "//@ never: or //@ eventually: with an expression, //@ sync: v, or //@ races: none or benign",
      "“{0}”不是探索注释：应为 //@ init: v=1，//@ final:、//@ always:、//@ never: 或 "
      "//@ eventually: 加表达式，//@ sync: v，或 //@ races: none 或 benign",
      Trim(comment));
}

/// Adds what is wrong with a requirement, in its place or else named.
void AddError(const Requirement& requirement, const Message& why, Message* errors) {
  const std::string separator = errors->en.empty() ? "" : "\n";
  if (const runtime::TextPlace& place = requirement.place; place.file != nullptr) {
    errors->en += fmt::format("{}{}{}{}", separator, place.Headline(), why.en, place.Excerpt());
    errors->zh += fmt::format("{}{}{}{}", separator, place.Headline(), why.zh, place.Excerpt());
    return;
  }
  const std::string what = fmt::format("{}: {}", ScopeName(requirement.scope), requirement.text);
  errors->en += fmt::format("{}'{}': {}", separator, what, why.en);
  errors->zh += fmt::format("{}“{}”：{}", separator, what, why.zh);
}

template <typename Names>
Result<std::vector<Property>> ReadAll(const std::vector<Requirement>& requirements,
                                      const Names& names) {
  std::vector<Property> properties;
  Message errors;
  for (const Requirement& requirement : requirements) {
    auto property = Property::Parse(requirement.text, names);
    if (property.ok()) {
      properties.push_back(std::move(property).value());
    } else {
      AddError(requirement, property.error().message, &errors);
    }
  }
  if (!errors.en.empty()) return Error{1, std::move(errors)};
  return properties;
}

bool HasFunction(const vm::Object& object, const std::string& name) {
  for (const vm::Function& function : object.functions) {
    if (function.name == name) return true;
  }
  return false;
}

}  // namespace

std::string_view ScopeName(Scope scope) {
  switch (scope) {
    case Scope::kFinal:
      return "final";
    case Scope::kAlways:
      return "always";
    case Scope::kNever:
      return "never";
    case Scope::kEventually:
      break;
  }
  return "eventually";
}

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
  CommentProblem problem;
  problem.scenario.path = path;
  problem.scenario.program = runtime::PathToScenario(problem.scenario, path);
  const auto file = std::make_shared<const runtime::TextFile>(path, source);
  runtime::PlacedErrors errors;
  ForEachComment(source, [&](int number, std::string_view line) {
    const std::string_view comment = Trim(line);
    std::string_view expression;
    const auto read = ReadComment(comment.substr(kMark.size()), &problem, &expression);
    if (!expression.empty()) {
      problem.requirements.back().place = PlaceIn(file, number, line, expression);
    }
    if (!read.ok()) errors.Add(PlaceIn(file, number, line, comment), read.error().message);
  });
  if (const auto failure = errors.Failure()) return *failure;
  return problem;
}

int FirstCommentLine(std::string_view source) {
  int first = 0;
  ForEachComment(source, [&](int number, std::string_view) {
    if (first == 0) first = number;
  });
  return first;
}

bool Problem::HasInvariants() const {
  for (const BoundRequirement& requirement : requirements) {
    if (requirement.scope != Scope::kFinal) return true;
  }
  return false;
}

Result<std::vector<Property>> ReadRequirements(const std::vector<Requirement>& requirements,
                                               const Model& names) {
  return ReadAll(requirements, names);
}

Result<std::vector<Property>> ReadRequirements(const std::vector<Requirement>& requirements,
                                               const runtime::Controller& names) {
  return ReadAll(requirements, names);
}

Result<Problem> BindProblem(Model model, const std::vector<Requirement>& requirements) {
  Problem problem{std::move(model), {}};
  auto properties = ReadRequirements(requirements, problem.model);
  if (!properties.ok()) return properties.error();
  for (size_t i = 0; i < requirements.size(); ++i) {
    problem.requirements.push_back({requirements[i].scope, std::move(properties.value()[i])});
  }
  if (std::ranges::count(requirements, Scope::kEventually, &Requirement::scope) > kEventuallyMax) {
    return MakeError(1, "there are more than {0} 'eventually' expressions",
                     "“eventually”表达式超过 {0} 个", kEventuallyMax);
  }
  return problem;
}

std::optional<RaceRule> RaceRuleNamed(std::string_view name) {
  if (name == "any") return RaceRule::kAny;
  if (name == "benign") return RaceRule::kBenign;
  if (name == "none") return RaceRule::kNone;
  return std::nullopt;
}

Result<SyncCells> SyncCellsNamed(const std::vector<std::string>& names, const vm::Object& object) {
  SyncCells cells;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(object.globals, name, &vm::Symbol::name);
    if (found == object.globals.end()) {
      return MakeError(1, "'sync' names '{0}', which is not a global variable",
                       "“sync”中的“{0}”不是全局变量", name);
    }
    const size_t end = size_t{found->id} + found->slots();
    if (cells.size() < end) cells.resize(end);
    std::fill(cells.begin() + found->id, cells.begin() + static_cast<std::ptrdiff_t>(end), true);
  }
  return cells;
}

Fault FindFault(const Problem& problem, const Model& state) {
  for (int thread = 0; thread < state.thread_count(); ++thread) {
    const ThreadEnd end = state.End(thread);
    if (end != ThreadEnd::kRunning && end != ThreadEnd::kFinished) {
      return {Fault::Kind::kThread, 0, thread};
    }
  }
  for (size_t i = 0; i < problem.requirements.size(); ++i) {
    const BoundRequirement& requirement = problem.requirements[i];
    if (requirement.scope == Scope::kEventually) continue;
    if (requirement.scope == Scope::kFinal && state.runnable() != 0) continue;
    if (requirement.property.Holds(state) == (requirement.scope == Scope::kNever)) {
      return {Fault::Kind::kRequirement, static_cast<int>(i), 0};
    }
  }
  return {};
}

}  // namespace oncard::explore
