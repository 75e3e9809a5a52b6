#include "explore/kept_cases.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "explore/case_exploration.h"
#include "explore/engines/shrink.h"
#include "explore/engines/walk.h"
#include "explore/models/islands.h"
#include "explore/scenario_exploration.h"
#include "explore/search/search_check.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/scenario/run/scenario_card.h"

namespace oncard::explore {
namespace {

/// The cases of what is searched.
class KeptCases {
 public:
  static Result<KeptCases> Of(const SearchedScenario& searched) {
    auto choices = ChoicesToExplore(searched.scenario, searched.requirements, searched.object);
    if (!choices.ok()) return choices.error();
    return KeptCases(searched, std::move(choices).value());
  }

  int64_t count() const { return choices_.cases(); }
  bool any_open() const { return !choices_.empty(); }
  bool with_card() const { return runtime::NeedsCard(searched_.scenario, searched_.object); }

  runtime::Scenario Case(int64_t number) const {
    return choices_.CaseOf(searched_.scenario, number);
  }
  Result<CardModel> Card(int64_t number, runtime::ScenarioErrors errors = {}) const {
    return CardModel::Create(Case(number), searched_.requirements, searched_.object,
                             std::move(errors));
  }
  Result<Problem> Program(int64_t number) const {
    return ProblemOfScenario(Case(number), searched_.requirements, searched_.object);
  }
  Result<Findings> Explore(int64_t number, const ExploreOptions& options) const {
    return ExploreCase(Case(number), searched_.requirements, searched_.object, options);
  }

  /// The findings of an exploration of a case, whose failure is that of `failing` statements.
  Result<Findings> FindingsOfCase(int64_t number, Exploration exploration,
                                  const std::vector<uint8_t>* failing) const {
    const runtime::Scenario chosen = Case(number);
    if (with_card()) {
      auto card = Card(number);
      if (!card.ok()) return card.error();
      if (failing != nullptr) exploration.failure = ShrinkCard(&card.value(), *failing);
      Findings findings = FindingsOf(chosen, &card.value(), std::move(exploration));
      AddTrace(chosen, searched_.object, &findings);
      return findings;
    }
    auto problem = Program(number);
    if (!problem.ok()) return problem.error();
    if (failing != nullptr) exploration.failure = Shrink(problem.value(), *failing);
    return FindingsOf(chosen, problem.value(), std::move(exploration));
  }

  /// Says in which case a search was ended.
  void NameIn(int64_t number, WayOut* way) const {
    if (any_open()) *way = NameCase(choices_.DescribeCase(number), std::move(*way));
  }

  /// Says of the findings which cases they are of.
  void Describe(std::optional<int64_t> failing, const std::vector<bool>& searched,
                Findings* findings) const {
    explore::Describe(searched_.scenario, &findings->subject);
    if (!any_open()) return;
    CaseSearch& cases = findings->cases.emplace();
    cases.choices = choices_.Describe();
    cases.cases = count();
    cases.searched = std::ranges::count(searched, true);
    cases.covered = choices_.Covered(searched);
    cases.in_order = false;
    if (!failing) return;
    cases.failing = choices_.DescribeCase(*failing);
    cases.scenario = std::make_shared<const runtime::Scenario>(Case(*failing));
  }

 private:
  KeptCases(const SearchedScenario& searched, runtime::Choices choices)
      : searched_(searched), choices_(std::move(choices)) {}

  SearchedScenario searched_;
  runtime::Choices choices_;
};

/// A hash of what is searched in all cases; `asked` is what is required in the first one.
uint64_t HashOfAll(const runtime::Scenario& scenario, uint64_t image,
                   const std::vector<Requirement>& asked) {
  runtime::Scenario hashed = scenario;
  hashed.program.clear();
  hashed.include_folders.clear();
  hashed.explore.reset();
  std::string text = fmt::format("{:x}\n{}", image, runtime::FormatScenario(hashed));
  for (const Requirement& requirement : asked) {
    text += fmt::format("\n{} {} {}", static_cast<int>(requirement.scope), requirement.Expression(),
                        requirement.at);
  }
  return XXH64(text.data(), text.size(), 0);
}

/// Whether the schedules of a case are divided by islands rather than into groups.
bool HasIslands(const CardModel& model, const ExploreOptions& options) {
  if (options.engine != EngineKind::kAuto || !options.islands || options.all) return false;
  return !model.asks_nothing() && Islands::Of(model).has_value();
}

bool IsToldToStop(const ExploreOptions& options) {
  return options.progress != nullptr && IsTold(&options.progress->stop);
}

/// Takes over what was found in places of the program, and what was not put to the test.
void AddRemarks(const Findings& findings, Remarks* remarks) {
  JoinFound(findings.refused, &remarks->refused);
  JoinFound(findings.card, &remarks->card);
  remarks->untested.Add(findings.untested);
}

void ShowRemarks(const Remarks& remarks, Findings* findings) {
  findings->refused = remarks.refused;
  findings->card = remarks.card;
}

// --- Random runs ---------------------------------------------------------------------------------

Result<Findings> ConcludeRuns(const KeptCases& cases, const SearchFile& file, Message why) {
  Exploration exploration = ConcludeSamples(file.engine, file.samples);
  const bool fails = file.samples.bad > 0;
  if (!fails && (!file.done() || !file.whole())) {
    if (!file.done()) exploration.verdict = Verdict::kIncomplete;
    exploration.why = file.done() || why.en.empty() ? WhyNotProved(file) : std::move(why);
  }
  const int64_t number = fails ? file.failing_case : 0;
  auto findings =
      cases.FindingsOfCase(number, std::move(exploration), fails ? &file.samples.failing : nullptr);
  if (!findings.ok()) return findings;
  // Which cases have had their runs is the same for all searches with so many.
  const bool all = file.whole() && file.done();
  const std::vector<bool> searched(static_cast<size_t>(cases.count()), all);
  cases.Describe(fails ? std::optional(number) : std::nullopt, searched, &findings.value());
  ShowRemarks(file.remarks, &findings.value());
  if (!fails && all) {
    findings.value().untested = file.remarks.untested.Texts();
    findings.value().knows_untested = true;
  }
  return findings;
}

Result<Findings> GoOnRuns(const KeptCases& cases, const ExploreOptions& options,
                          const SearchKeeper& keep, SearchFile* file) {
  ExploreOptions rest = WithOptionsOf(*file, options);
  bool goes_on = true;
  while (goes_on && file->runs_cut > 0) {
    const auto [first, count] = RunsOfPart(file->runs, {file->held.front(), file->parts});
    const int64_t next = first + count - file->runs_cut;
    const int64_t number = ShareOfRun(next, file->runs, cases.count());
    const auto [first_of_case, of_case] = RunsOfShare(file->runs, number, cases.count());
    rest.first_run = next;
    rest.runs = std::min(file->runs_cut, first_of_case + of_case - next);
    auto found = cases.Explore(number, rest);
    if (!found.ok()) return found;
    Findings& findings = found.value();
    file->runs_cut -= findings.exploration.samples->runs;
    AddSamples(std::move(*findings.exploration.samples), number, file);
    AddRemarks(findings, &file->remarks);
    const bool paused = options.progress != nullptr && options.progress->TakePause();
    goes_on = paused ? file->runs_cut > 0 && keep(*file) : !IsToldToStop(options);
  }
  return ConcludeRuns(cases, *file, WhyIncomplete(options, {}));
}

// --- Units ---------------------------------------------------------------------------------------

/// For each case: all its schedules have been searched.
std::vector<bool> CasesSearched(const SearchFile& file) {
  const UnitSearch& units = *file.units;
  std::vector<bool> searched;
  for (int64_t number = 0; number < units.cases; ++number) {
    bool whole = true;
    for (int64_t unit = number * units.groups; unit < (number + 1) * units.groups; ++unit) {
      const auto part = static_cast<int>(unit % file.parts) + 1;
      whole = whole && std::ranges::binary_search(file.held, part) &&
              !std::ranges::binary_search(units.left, unit);
    }
    searched.push_back(whole);
  }
  return searched;
}

/// Groups of schedules, of all cases, that have been searched.
int64_t UnitsSearched(const SearchFile& file) {
  int64_t held = 0;
  for (const int part : file.held) {
    held += static_cast<int64_t>(UnitsOfPart(file.units->units(), part, file.parts).size());
  }
  return held - static_cast<int64_t>(file.units->left.size());
}

/// Why a search was ended before its units.
Message WhyEnded(const SearchFile& file, const Message& why) {
  const UnitSearch& units = *file.units;
  if (units.groups == 1) {
    return MakeMessage("{0}; {1} of {2} cases were searched", "{3}；共 {2} 种情形，已搜索 {1} 种",
                       why.en, UnitsSearched(file), units.cases, why.zh);
  }
  return MakeMessage("{0}; {1} of {2} groups of schedules were searched",
                     "{3}；共 {2} 组调度，已搜索 {1} 组", why.en, UnitsSearched(file),
                     units.units(), why.zh);
}

/// The options of a unit.
ExploreOptions OptionsOfUnit(const SearchFile& file, int64_t unit, const ExploreOptions& options) {
  const UnitSearch& units = *file.units;
  ExploreOptions rest = options;
  rest.engine = file.engine;
  rest.all = units.all;
  rest.islands = units.islands;
  rest.reductions = units.reductions;
  rest.merge_private = units.merge_private;
  rest.preemption_limit = units.preemptions;
  rest.cases = units.cases;
  rest.groups = units.groups;
  rest.group = static_cast<int>(unit % units.groups);
  return rest;
}

/// Searches the unit that fails once more.
Result<Findings> FailAgain(const KeptCases& cases, const ExploreOptions& options,
                           const SearchFile& file) {
  const int64_t unit = *file.units->failing;
  auto found = cases.Explore(unit / file.units->groups, OptionsOfUnit(file, unit, options));
  if (!found.ok() || found.value().exploration.failure) return found;
  return MakeError(1,
                   "the file says that unit {0} fails, but it does not within these limits: "
                   "explore again",
                   "文件称第 {0} 个单元出错，但在当前限制内并未出错：请重新探索", unit);
}

/// The search so far. `shown` are the findings of the unit that fails, or of one that is not
/// complete, if there is one.
Result<Findings> ConcludeUnits(const KeptCases& cases, const ExploreOptions& options,
                               const SearchFile& file, std::optional<Findings> shown) {
  const UnitSearch& units = *file.units;
  if (units.failing && !shown) {
    auto again = FailAgain(cases, options, file);
    if (!again.ok()) return again;
    shown = std::move(again).value();
  }
  Exploration sums = units.found.value_or(Exploration{});
  sums.engine = units.found ? sums.engine : file.engine;
  sums.why = {};
  if (units.failing) {
    sums.verdict = Verdict::kFailed;
    sums.engine = shown->exploration.engine;
    sums.failure = std::move(shown->exploration.failure);
    // The file does not say them.
    sums.races = std::move(shown->exploration.races);
  } else if (!file.done()) {
    sums.verdict = Verdict::kIncomplete;
    sums.why = WhyNotProved(file);
    if (shown || IsToldToStop(options)) {
      sums.why = WhyEnded(file, WhyIncomplete(options, DescribeLimits(options)));
    }
    if (shown) sums.reached = std::move(shown->exploration.reached);
  } else if (!file.whole()) {
    sums.verdict = Verdict::kPassed;
    sums.why = WhyNotProved(file);
  } else if (sums.verdict == Verdict::kPassed) {
    if (sums.bounded) sums.why = DescribeBound(*sums.bounded);
    BoundByHorizon(Horizon(sums.horizon), &sums);
  }
  // What is not known of all is not complete.
  const bool whole = file.done() && file.whole() && (!units.failing || units.left.empty());
  if (sums.states) sums.states->complete = sums.states->complete && whole;
  if (sums.traces) sums.traces->complete = sums.traces->complete && whole;
  std::optional<int64_t> failing;
  if (units.failing) failing = *units.failing / units.groups;
  if (!shown) {
    auto first = cases.FindingsOfCase(0, std::move(sums), nullptr);
    if (!first.ok()) return first;
    shown = std::move(first).value();
  } else {
    shown->exploration = std::move(sums);
  }
  cases.Describe(failing, CasesSearched(file), &*shown);
  ShowRemarks(file.remarks, &*shown);
  if (shown->exploration.verdict == Verdict::kProved ||
      (shown->exploration.verdict == Verdict::kPassed && whole)) {
    shown->untested = file.remarks.untested.Texts();
    shown->knows_untested = true;
  }
  return std::move(*shown);
}

/// Adds what a unit has shown.
void TakeUnit(Findings* findings, SearchFile* file) {
  UnitSearch& units = *file->units;
  Exploration next = findings->exploration;
  next.failure.reset();
  next.search = {};
  next.reached.reset();
  // The file does not say what was executed, so no search that is kept does.
  next.coverage = {};
  if (units.found) {
    AddCase(std::move(next), &*units.found);
  } else {
    units.found = std::move(next);
  }
  AddRemarks(*findings, &file->remarks);
}

Result<Findings> GoOnUnits(const KeptCases& cases, const ExploreOptions& options,
                           const SearchKeeper& keep, SearchFile* file) {
  UnitSearch& units = *file->units;
  std::optional<Findings> shown;
  int64_t states = 0;
  int64_t executions = 0;
  if (options.progress != nullptr) {
    options.progress->estimates = false;
    if (units.groups == 1) options.progress->cases = units.cases;
  }
  while (!file->done() && !IsToldToStop(options)) {
    const int64_t unit = units.left.front();
    if (options.progress != nullptr) options.progress->cases_done = UnitsSearched(*file);
    ExploreOptions rest = OptionsOfUnit(*file, unit, options);
    rest.states_before = std::min<int64_t>(states, rest.state_limit);
    rest.state_limit -= static_cast<uint32_t>(rest.states_before);
    if (rest.execution_limit < ExploreOptions{}.execution_limit) {
      rest.execution_limit = std::max<int64_t>(rest.execution_limit - executions, 0);
    }
    auto found = cases.Explore(unit / units.groups, rest);
    if (!found.ok()) return found;
    Findings& findings = found.value();
    states += StatesUsed(findings.exploration);
    executions += ExecutionsUsed(findings.exploration);
    if (findings.exploration.verdict == Verdict::kIncomplete) {
      cases.NameIn(unit / units.groups, &findings.way_out);
      if (!shown) shown = std::move(findings);
      break;
    }
    units.left.erase(units.left.begin());
    TakeUnit(&findings, file);
    if (findings.exploration.failure && !units.failing) {
      units.failing = unit;
      shown = std::move(findings);
    }
    if (!keep(*file)) break;
  }
  return ConcludeUnits(cases, options, *file, std::move(shown));
}

}  // namespace

Result<bool> IsKeptByCases(const SearchedScenario& searched) {
  const auto cases = KeptCases::Of(searched);
  if (!cases.ok()) return cases.error();
  return cases.value().with_card() || cases.value().any_open();
}

Result<uint64_t> HashByCases(const SearchedScenario& searched) {
  const auto cases = KeptCases::Of(searched);
  if (!cases.ok()) return cases.error();
  if (cases.value().with_card()) {
    const auto card = cases.value().Card(0);
    if (!card.ok()) return card.error();
    return HashOfAll(searched.scenario, card.value().image()->hash, card.value().Requirements());
  }
  const auto problem = cases.value().Program(0);
  if (!problem.ok()) return problem.error();
  return HashOfAll(searched.scenario, HashOf(problem.value()), {});
}

Result<SearchFile> BeginByCases(const SearchedScenario& searched, const ExploreOptions& options,
                                const SearchPart& part) {
  const auto of = KeptCases::Of(searched);
  if (!of.ok()) return of.error();
  const KeptCases& cases = of.value();
  SearchFile file;
  file.engine = options.engine;
  file.races = searched.scenario.races;
  file.parts = part.count;
  file.held = {part.number};
  const auto hash = HashByCases(searched);
  if (!hash.ok()) return hash.error();
  file.problem = hash.value();
  if (IsRandom(options.engine)) {
    if (auto enough = CheckRuns(options, cases.count()); !enough.ok()) return enough.error();
    BeginRuns(options, part, &file);
    return file;
  }
  if (!cases.with_card() && searched.scenario.races == "benign") {
    return MakeError(1,
                     "the search for benign races cannot be saved or split where choices are open: "
                     "explore it in one piece",
                     "存在选择时，对无害竞争的搜索不能保存或拆分：请一次完成探索");
  }
  UnitSearch& units = file.units.emplace();
  units.cases = cases.count();
  units.all = options.all;
  units.islands = options.islands;
  units.reductions = options.reductions;
  units.merge_private = options.merge_private;
  units.preemptions = options.preemption_limit;
  if (cases.with_card()) {
    runtime::ScenarioErrors errors;
    CheckCardSearch(searched.scenario, options, &errors);
    const auto card = cases.Card(0, std::move(errors));
    if (!card.ok()) return card.error();
    const bool by_states =
        options.engine == EngineKind::kAuto || options.engine == EngineKind::kStateful;
    const bool grouped = by_states && !HasIslands(card.value(), options);
    if (grouped) units.groups = GroupsFor(units.cases, part.count);
  }
  if (units.units() < part.count) {
    return MakeError(
        1,
        "there are {0} cases to be divided, and {1} parts: what is searched in a case cannot be "
        "divided (with a card it can, by the engine stateful)",
        "可拆分的情形只有 {0} 种，而部分数为 {1}：一种情形之内的搜索不能拆分（带控制卡时，stateful "
        "引擎可以）",
        units.units(), part.count);
  }
  units.left = UnitsOfPart(units.units(), part.number, part.count);
  return file;
}

Result<void> CheckByCases(const SearchedScenario& searched, const SearchFile& file) {
  const auto of = KeptCases::Of(searched);
  if (!of.ok()) return of.error();
  const KeptCases& cases = of.value();
  if (!file.units && !IsRandom(file.engine)) {
    return MakeError(1, "engine: this search is one of units; explore again",
                     "engine：该搜索应按单元进行；请重新探索");
  }
  if (file.units &&
      (file.units->cases != cases.count() || (file.units->groups > 1 && !cases.with_card()))) {
    return MakeError(1, "units: the program has {0} cases; explore again",
                     "units：程序有 {0} 种情形；请重新探索", cases.count());
  }
  if (file.failing_case >= cases.count()) {
    return MakeError(1, "samples.failing_case: the program has {0} cases; explore again",
                     "samples.failing_case：程序有 {0} 种情形；请重新探索", cases.count());
  }
  std::vector<End> ends;
  if (file.units && file.units->found) ends = file.units->found->ends;
  if (cases.with_card()) {
    auto card = cases.Card(file.failing_case);
    if (!card.ok()) return card.error();
    if (!file.units) return CheckSamples(&card.value(), file.samples);
    return CheckEnds(EndOf(card.value(), card.value().Start()).size(), ends);
  }
  const auto problem = cases.Program(file.failing_case);
  if (!problem.ok()) return problem.error();
  if (!file.units) return CheckSearch(problem.value(), file);
  return CheckEnds(EndOf(problem.value().model).size(), ends);
}

Result<Findings> GoOnByCases(const SearchedScenario& searched, const ExploreOptions& options,
                             const SearchKeeper& keep, SearchFile* file) {
  const auto cases = KeptCases::Of(searched);
  if (!cases.ok()) return cases.error();
  return file->units ? GoOnUnits(cases.value(), options, keep, file)
                     : GoOnRuns(cases.value(), options, keep, file);
}

Result<Findings> ConcludeByCases(const SearchedScenario& searched, const ExploreOptions& options,
                                 const SearchFile& file) {
  const auto cases = KeptCases::Of(searched);
  if (!cases.ok()) return cases.error();
  return file.units ? ConcludeUnits(cases.value(), options, file, std::nullopt)
                    : ConcludeRuns(cases.value(), file, {});
}

}  // namespace oncard::explore
