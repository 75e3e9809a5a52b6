#include "python/runs.h"

#include <utility>

#include "explore/source_comments.h"
#include "runtime/scenario/run/requirement_watch.h"

namespace oncard::python {

Result<RunOutcome> Run(const Source& source, const RunWish& wish, const std::atomic<bool>* stop) {
  runtime::RunOptions options;
  const auto silent = WarningsNamed(wish.silent);
  if (!silent.ok()) return silent.error();
  options.silent = silent.value();
  options.show = wish.show;
  options.trace = wish.trace;
  options.strict_commands = wish.strict_commands;
  options.stop = stop;

  auto project = ReadProject(source, FilesOf(source), runtime::ScenarioUse::kRun);
  if (!project.ok()) return project.error();
  auto& [scenario, compilation, schedule, calls] = project.value();
  RunOutcome outcome;
  outcome.compilation = std::move(compilation);
  if (!outcome.compilation.ok()) return outcome;
  if (!wish.columns.empty()) {
    scenario.trace = wish.columns;
    scenario.text_places.erase("trace");
  }
  options.replay = std::move(schedule);
  auto result = runtime::RunWithRequirements(scenario, *outcome.compilation.object, options);
  if (!result.ok()) return result.error();
  if (scenario.program != source.main && !outcome.compilation.files.empty()) {
    const auto unused =
        explore::DescribeUnusedComments(scenario, outcome.compilation.files[0].text());
    if (unused) result.value().warnings.push_back(*unused);
  }
  outcome.title = runtime::TitleOf(scenario);
  outcome.result = std::move(result).value();
  return outcome;
}

}  // namespace oncard::python
