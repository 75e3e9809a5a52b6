#include "python/searches.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "explore/question.h"
#include "explore/scenario_exploration.h"
#include "runtime/scenario/file/search_names.h"
#include "tools/program_warnings.h"

namespace oncard::python {
namespace {

/// A setting with its range: that of the option of `oncard explore`, but a seed has 63 bits.
struct Setting {
  std::string_view option;
  const std::optional<int64_t>& value;
  int64_t least;
  int64_t most;
};

std::vector<Setting> SettingsOf(const SearchWish& wish) {
  return {{"--max-executions", wish.max_executions, 1, runtime::kSearchCountMax},
          {"--max-states", wish.max_states, 1, runtime::kSearchStatesMax},
          {"--runs", wish.runs, 1, runtime::kSearchCountMax},
          {"--seed", wish.seed, 0, INT64_MAX},
          {"--depth", wish.depth, 1, explore::kPctDepthMax},
          {"--preemptions", wish.preemptions, 0, runtime::kPreemptionsMax}};
}

constexpr std::string_view kNo = "--no-";

/// `--max-states` as an argument of Python: `max_states`; `--no-islands`: `islands`.
std::string ArgumentName(std::string_view option) {
  std::string name(option.substr(option.starts_with(kNo) ? kNo.size() : 2));
  std::ranges::replace(name, '-', '_');
  return name;
}

/// One of the names, or empty.
Result<void> CheckName(std::string_view argument, std::string_view name,
                       std::span<const std::string_view> names) {
  if (name.empty() || std::ranges::find(names, name) != names.end()) return {};
  return MakeError(1, "'{0}' is no value of '{1}': use {2}", "“{0}”不是“{1}”的值：应使用 {2}", name,
                   argument, fmt::join(names, ", "));
}

/// Ranges, and that the engine uses what is given.
Result<void> CheckSettings(const SearchWish& wish, explore::EngineKind engine) {
  const std::vector<Setting> settings = SettingsOf(wish);
  for (const Setting& setting : settings) {
    if (!setting.value || (*setting.value >= setting.least && *setting.value <= setting.most)) {
      continue;
    }
    return MakeError(1, "'{0}' must be from {1} to {2}, not {3}",
                     "“{0}”应为 {1} 到 {2}，而不是 {3}", ArgumentName(setting.option),
                     setting.least, setting.most, *setting.value);
  }
  const std::string_view name = explore::EngineName(engine);
  for (const runtime::SearchSetting& known : runtime::SearchSettings()) {
    const auto found = std::ranges::find(settings, known.option, &Setting::option);
    const bool given = found != settings.end()
                           ? found->value.has_value()
                           : (known.option == "--merge-private" && wish.merge_private) ||
                                 (known.option == "--no-dead-locals" && wish.dead_locals) ||
                                 (known.option == "--no-symmetry" && wish.symmetry) ||
                                 (known.option == "--no-islands" && wish.islands) ||
                                 (known.option == "--no-reductions" && wish.reductions);
    if (!given || known.UsedBy(name)) continue;
    return Error{1, runtime::DescribeUnusedSetting(known, ArgumentName(known.option), name)};
  }
  return {};
}

Result<explore::ExploreOptions> OptionsOf(const SearchWish& wish,
                                          const runtime::ExploreWish& wished) {
  explore::ExploreOptions options = explore::OptionsOf(wished);
  if (!wish.engine.empty()) options.engine = *explore::EngineNamed(wish.engine);
  if (auto checked = CheckSettings(wish, options.engine); !checked.ok()) return checked.error();
  options.execution_limit = wish.max_executions.value_or(options.execution_limit);
  options.state_limit = static_cast<uint32_t>(wish.max_states.value_or(options.state_limit));
  options.runs = wish.runs.value_or(options.runs);
  if (wish.seed) options.seed = static_cast<uint64_t>(*wish.seed);
  options.depth = static_cast<int>(wish.depth.value_or(options.depth));
  options.preemption_limit = static_cast<int>(wish.preemptions.value_or(options.preemption_limit));
  options.merge_private = wish.merge_private;
  options.dead_locals = wish.dead_locals.value_or(options.dead_locals);
  options.symmetry = wish.symmetry.value_or(options.symmetry);
  options.islands = wish.islands.value_or(options.islands);
  options.reductions = wish.reductions.value_or(options.reductions);
  options.all = wish.all;
  return options;
}

/// That of the file, with what is asked beyond it.
Result<explore::Question> QuestionOf(const Source& source, const SearchWish& wish,
                                     const session::Project& project, std::string_view text) {
  for (const runtime::Requirement& requirement : wish.requirements) {
    if (auto form = runtime::CheckForm(requirement); !form.ok()) return form.error();
  }
  auto question =
      explore::QuestionOf(source.main, project.scenario, text, *project.compilation.object);
  if (!question.ok()) return question;
  auto& [scenario, requirements] = question.value();
  if (!wish.races.empty()) {
    scenario.races = wish.races;
    scenario.text_places.erase("races");
  }
  requirements.insert(requirements.end(), wish.requirements.begin(), wish.requirements.end());
  return question;
}

Result<explore::Findings> Search(const SearchWish& wish, const explore::Question& question,
                                 const vm::Object& object, std::string_view text,
                                 const session::Files& files, explore::SearchProgress* progress) {
  const runtime::ExploreWish wished = question.scenario.explore.value_or(runtime::ExploreWish{});
  if (wish.engine.empty() && !wished.follow.empty()) {
    return explore::FollowWished(question, object, text,
                                 [&files](const std::string& path) { return files.Read(path); });
  }
  auto options = OptionsOf(wish, wished);
  if (!options.ok()) return options.error();
  options.value().progress = progress;
  return explore::ExploreScenario(question.scenario, question.requirements, object,
                                  options.value());
}

}  // namespace

Result<SearchOutcome> Explore(const Source& source, const SearchWish& wish,
                              explore::SearchProgress* progress) {
  const auto silent = WarningsNamed(wish.silent);
  if (!silent.ok()) return silent.error();
  for (const auto& checked : {CheckName("engine", wish.engine, runtime::kEngineNames),
                              CheckName("races", wish.races, runtime::kRaceRuleNames)}) {
    if (!checked.ok()) return checked.error();
  }
  const session::Files files = FilesOf(source);
  auto project = ReadProject(source, files, runtime::ScenarioUse::kExplore);
  if (!project.ok()) return project.error();
  SearchOutcome outcome;
  if (!project.value().compilation.ok()) {
    outcome.compilation = std::move(project.value().compilation);
    return outcome;
  }
  const vm::Object& object = *project.value().compilation.object;
  explore::ProgramText text = explore::TextOf(project.value().compilation);
  const auto question = QuestionOf(source, wish, project.value(), text.text);
  if (!question.ok()) return question.error();
  auto found = Search(wish, question.value(), object, text.text, files, progress);
  if (!found.ok()) return found.error();
  explore::Findings& findings = found.value();
  findings.source = std::move(text);
  const explore::Verdict verdict = findings.exploration.verdict;
  outcome.cut = progress->interrupted && verdict != explore::Verdict::kProved &&
                verdict != explore::Verdict::kFailed;
  outcome.warnings = tools::ProgramWarnings(findings, silent.value(),
                                            runtime::ProgramPath(question.value().scenario));
  if (findings.exploration.failure) {
    auto schedule = explore::FailureScheduleBeside(source.main, question.value(), object, findings);
    if (!schedule.ok()) return schedule.error();
    outcome.schedule = std::move(schedule).value();
  }
  outcome.findings = std::move(findings);
  outcome.compilation = std::move(project.value().compilation);
  return outcome;
}

}  // namespace oncard::python
