#include "explore/kept_exploration.h"

#include <utility>

#include "explore/scenario_exploration.h"
#include "explore/search/search_check.h"

namespace oncard::explore {
namespace {

Result<Problem> ProblemOf(const SearchedScenario& searched) {
  return ProblemOfScenario(searched.scenario, searched.requirements, searched.object);
}

Result<SearchFile> BeginAlone(const Problem& problem, const ExploreOptions& options,
                              const SearchPart& part) {
  SearchFile file;
  file.problem = HashOf(problem);
  file.parts = part.count;
  file.held = {part.number};
  if (options.engine == EngineKind::kAuto || options.engine == EngineKind::kDpor) {
    file.traces = TracesOfPart(problem, part);
    return file;
  }
  if (IsRandom(options.engine)) {
    BeginRuns(options, part, &file);
    return file;
  }
  return MakeError(
      1, "searches of the engine {0} cannot be saved or split: use dpor, random, pct or pos",
      "{0} 引擎的搜索不能保存或拆分：请使用 dpor、random、pct 或 pos", EngineName(options.engine));
}

}  // namespace

Result<uint64_t> HashOfKept(const SearchedScenario& searched) {
  const auto by_cases = IsKeptByCases(searched);
  if (!by_cases.ok()) return by_cases.error();
  if (by_cases.value()) return HashByCases(searched);
  const auto problem = ProblemOf(searched);
  if (!problem.ok()) return problem.error();
  return HashOf(problem.value());
}

Result<SearchFile> BeginKept(const SearchedScenario& searched, const ExploreOptions& options,
                             const SearchPart& part) {
  const auto by_cases = IsKeptByCases(searched);
  if (!by_cases.ok()) return by_cases.error();
  if (by_cases.value()) return BeginByCases(searched, options, part);
  const auto problem = ProblemOf(searched);
  if (!problem.ok()) return problem.error();
  auto begun = BeginAlone(problem.value(), options, part);
  if (begun.ok()) begun.value().races = searched.scenario.races;
  return begun;
}

Result<void> CheckKept(const SearchedScenario& searched, const SearchFile& file) {
  const auto by_cases = IsKeptByCases(searched);
  if (!by_cases.ok()) return by_cases.error();
  if (by_cases.value()) return CheckByCases(searched, file);
  const auto problem = ProblemOf(searched);
  if (!problem.ok()) return problem.error();
  return CheckSearch(problem.value(), file);
}

Result<Findings> GoOnKept(const SearchedScenario& searched, const ExploreOptions& options,
                          const SearchKeeper& keep, SearchFile* file) {
  const auto by_cases = IsKeptByCases(searched);
  if (!by_cases.ok()) return by_cases.error();
  if (by_cases.value()) return GoOnByCases(searched, options, keep, file);
  const auto problem = ProblemOf(searched);
  if (!problem.ok()) return problem.error();
  auto exploration = GoOn(problem.value(), options, keep, file);
  if (!exploration.ok()) return exploration.error();
  Findings findings =
      FindingsOf(searched.scenario, problem.value(), std::move(exploration).value());
  if (findings.exploration.verdict == Verdict::kIncomplete) {
    findings.way_out = WayOutOf(findings.subject, findings.exploration,
                                WithOptionsOf(*file, options), problem.value());
  }
  return findings;
}

Result<Findings> ConcludeKept(const SearchedScenario& searched, const ExploreOptions& options,
                              const SearchFile& file) {
  const auto by_cases = IsKeptByCases(searched);
  if (!by_cases.ok()) return by_cases.error();
  if (by_cases.value()) return ConcludeByCases(searched, options, file);
  const auto problem = ProblemOf(searched);
  if (!problem.ok()) return problem.error();
  return FindingsOf(searched.scenario, problem.value(), Conclude(problem.value(), file));
}

}  // namespace oncard::explore
