#include "explore/source_comments.h"

#include <algorithm>
#include <utility>

#include "explore/models/problem.h"
#include "runtime/scenario/file/placed_errors.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/run/assert_watch.h"

namespace oncard::explore {

Result<void> AddComments(const std::string& path, std::string_view source, const vm::Object& object,
                         runtime::Scenario* scenario) {
  if (FirstCommentLine(source) == 0 && !runtime::HasAsserts(object)) return {};
  const bool binds =
      scenario->threads.empty() &&
      std::ranges::find(object.functions, "t0", &vm::Function::name) != object.functions.end();
  auto read = binds ? ReadComments(path, source, object) : ReadCommentLines(path, source);
  if (!read.ok()) return read.error();
  runtime::PlacedErrors refused;
  for (const auto& [key, place] : read.value().of_all_schedules) {
    refused.Add(
        place,
        MakeMessage("'{0}' concerns all schedules, a single run cannot check it: "
                    "use 'oncard explore', or remove it",
                    "“{0}”针对所有调度，单次运行无法检查：请用“oncard explore”，或去掉", key));
  }
  if (auto failure = refused.Failure()) return *std::move(failure);
  runtime::Scenario& said = read.value().scenario;
  if (binds) scenario->threads = std::move(said.threads);
  scenario->endless = said.endless;
  scenario->livelock = said.livelock;
  scenario->deadlock = said.deadlock;
  scenario->globals.insert(scenario->globals.begin(), said.globals.begin(), said.globals.end());
  runtime::AddRequirements(read.value().requirements, scenario);
  return {};
}

std::optional<Message> DescribeUnusedComments(const runtime::Scenario& scenario,
                                              std::string_view source) {
  const int line = FirstCommentLine(source);
  if (line == 0) return std::nullopt;
  return MakeMessage(
      "{0}:{1}: this comment is not checked: the requirements come from the scenario; write it "
      "there",
      "{0}:{1}：未检查该注释：使用场景时由场景说明应成立的条件；应写入场景",
      runtime::ProgramPath(scenario), line);
}

}  // namespace oncard::explore
