#include "explore/scenario_exploration.h"

#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <filesystem>

#include "base/path_bytes.h"
#include "explore/case_exploration.h"
#include "explore/engines/shrink.h"
#include "explore/engines/walk.h"
#include "runtime/scenario/run/adapted_schedule.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/scenario/run/response.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_run.h"
#include "runtime/scenario/run/scenario_start.h"

namespace oncard::explore {
namespace {

/// Maximum number of statements when the threads run one after the other, and how many consecutive
/// ones a thread may take: a thread that waits in a loop must let the others continue.
constexpr int64_t kSerialSteps = 100'000;
constexpr int64_t kSerialTurn = 10'000;

/// The end that is reached when each thread runs as long as it can; empty if they do not end.
template <typename Walk>
std::optional<End> SerialEnd(Walk* walk) {
  int last = -1;
  int64_t turn = 0;
  for (int64_t step = 0; step < kSerialSteps && !walk->ended(); ++step) {
    const uint32_t choices = walk->choices();
    if (last < 0 || (choices >> last & 1) == 0 || turn == kSerialTurn) {
      const uint32_t others = last < 0 ? choices : choices & ~(uint32_t{1} << last);
      last = std::countr_zero(others != 0 ? others : choices);
      turn = 0;
    }
    walk->Step(last);
    ++turn;
  }
  if (!walk->finished()) return std::nullopt;
  return walk->EndNow();
}

/// The statements of a schedule, by the subject's thread numbers.
std::vector<uint8_t> StepsOf(const Subject& subject, const vm::Schedule& schedule) {
  std::vector<uint8_t> steps;
  for (const vm::ScheduleSegment& segment : schedule.segments) {
    for (size_t thread = 0; thread < subject.threads.size(); ++thread) {
      if (subject.threads[thread].thread != segment.thread) continue;
      steps.insert(steps.end(), static_cast<size_t>(segment.statements),
                   static_cast<uint8_t>(thread));
    }
  }
  return steps;
}

Result<Findings> ExploreProgram(const runtime::Scenario& scenario,
                                const std::vector<Requirement>& requirements, vm::Object object,
                                const ExploreOptions& options) {
  const auto problem = ProblemOfScenario(scenario, requirements, std::move(object));
  if (!problem.ok()) return problem.error();
  auto exploration = Explore(problem.value(), options);
  if (!exploration.ok()) return exploration.error();
  const bool good = IsGood(exploration.value().verdict);
  Findings findings = FindingsOf(scenario, problem.value(), std::move(exploration).value());
  if (good) findings.untested = UntestedOf(problem.value());
  findings.knows_untested = good;
  if (findings.exploration.verdict == Verdict::kIncomplete) {
    findings.way_out = WayOutOf(findings.subject, findings.exploration, options, problem.value());
  }
  return findings;
}

/// The place where the scenario names the engine; empty if it names another one.
runtime::TextPlace PlaceOfEngine(const runtime::Scenario& scenario, EngineKind engine) {
  const bool named = scenario.explore && EngineNamed(scenario.explore->engine) == engine;
  return named ? runtime::PlaceOfText(scenario, "explore.engine") : runtime::TextPlace{};
}

Result<Findings> ExploreWithCard(const runtime::Scenario& scenario,
                                 const std::vector<Requirement>& requirements, vm::Object object,
                                 const ExploreOptions& options) {
  runtime::ScenarioErrors errors;
  CheckCardSearch(scenario, options, &errors);
  auto model = CardModel::Create(scenario, requirements, std::move(object), std::move(errors));
  if (!model.ok()) return model.error();
  Exploration exploration = ExploreCard(&model.value(), options);
  std::vector<Message> untested = model.value().Untested();
  const bool good = IsGood(exploration.verdict);
  Findings findings = FindingsOf(scenario, &model.value(), std::move(exploration));
  if (good) findings.untested = std::move(untested);
  findings.knows_untested = good;
  if (findings.exploration.verdict == Verdict::kIncomplete) {
    findings.way_out = WayOutOf(findings.subject, findings.exploration, options, &model.value());
  }
  AddTrace(scenario, model.value().image()->object, &findings);
  return findings;
}

}  // namespace

ExploreOptions OptionsOf(const runtime::ExploreWish& wish) {
  ExploreOptions options;
  options.engine = EngineNamed(wish.engine).value_or(EngineKind::kAuto);
  if (wish.max_executions != 0) options.execution_limit = wish.max_executions;
  if (wish.max_states != 0) options.state_limit = static_cast<uint32_t>(wish.max_states);
  if (wish.runs != 0) options.runs = wish.runs;
  return options;
}

bool ChecksSomething(const runtime::Scenario& scenario) {
  if (!scenario.expectations.empty() || !RequirementsOf(scenario).empty()) return true;
  // An exploration also looks for data races, and a failure that is expected is a requirement.
  return scenario.explore && (scenario.races != runtime::Scenario{}.races ||
                              scenario.explore->verdict == VerdictName(Verdict::kFailed));
}

void Describe(const runtime::Scenario& scenario, Subject* subject) {
  const auto name_of = [](const std::string& path) { return FileNameOf(PathOf(path).filename()); };
  subject->program = name_of(scenario.program);
  if (scenario.path.ends_with(".toml")) subject->scenario = name_of(scenario.path);
  // The folders of the files do not influence what is explored.
  runtime::Scenario hashed = scenario;
  hashed.program = subject->program;
  hashed.include_folders.clear();
  const std::string text = runtime::FormatScenario(hashed);
  subject->scenario_hash = XXH64(text.data(), text.size(), 0);
  subject->races = *RaceRuleNamed(scenario.races);
  subject->sync = scenario.sync;
  subject->endless = scenario.endless;
  subject->may_last = runtime::MayLastForEver(scenario);
  subject->may_deadlock = runtime::MayDeadlock(scenario);
  if (!runtime::NeedsCard(scenario, subject->image->object)) return;
  subject->card = CardConditionsOf(scenario);
}

CardConditions CardConditionsOf(const runtime::Scenario& scenario) {
  return {scenario.rate,     scenario.cycle_us, scenario.axis_count,
          scenario.limit_ms, scenario.until_us, scenario.world};
}

Findings FindingsOf(const runtime::Scenario& scenario, const Problem& problem,
                    Exploration exploration) {
  Findings findings = {SubjectOf(problem), std::move(exploration), {}, {}};
  Describe(scenario, &findings.subject);
  if (findings.exploration.failure) {
    findings.trail = Follow(problem, *findings.exploration.failure);
  } else if (findings.subject.requirements.empty()) {
    ProgramWalk walk(problem);
    findings.start = walk.EndNow();
    findings.serial_end = SerialEnd(&walk);
  }
  return findings;
}

Findings FindingsOf(const runtime::Scenario& scenario, CardModel* model, Exploration exploration) {
  Findings findings = {SubjectOf(*model), std::move(exploration), {}, {}};
  Describe(scenario, &findings.subject);
  if (findings.exploration.failure) {
    findings.trail = Follow(model, *findings.exploration.failure);
  } else if (findings.subject.requirements.empty()) {
    CardWalk walk(model, false);
    findings.start = walk.EndNow();
    findings.serial_end = SerialEnd(&walk);
  }
  findings.refused = model->refused();
  findings.card = model->found();
  return findings;
}

void AddTrace(const runtime::Scenario& scenario, const vm::Object& object, Findings* findings) {
  // A run that is too long to be listed is also too long to be drawn.
  if (!findings->exploration.failure || findings->trail.skipped > 0) return;
  runtime::RunOptions options;
  options.trace = true;
  options.replay = std::make_shared<const vm::Schedule>(
      ScheduleOf(findings->subject, *findings->exploration.failure));
  auto run = runtime::RunScenario(scenario, object, options);
  if (run.ok()) findings->trail.trace = std::move(run.value().trace);
}

void CheckCardSearch(const runtime::Scenario& scenario, const ExploreOptions& options,
                     runtime::ScenarioErrors* errors) {
  if (options.engine == EngineKind::kDpor) {
    errors->Add(
        PlaceOfEngine(scenario, options.engine),
        {"time and the card are part of the states here: use the engine stateful, bounded, random, "
         "pct or pos",
         "此处时间与控制卡属于状态的一部分：请使用 stateful、bounded、random、pct 或 pos 引擎"});
  }
  if (options.merge_private == true) {
    errors->Add({}, {"with the card every statement takes time: none can be merged",
                     "带控制卡时每条语句都占用时间：不能合并"});
  }
}

Result<Problem> ProblemOfScenario(const runtime::Scenario& scenario,
                                  const std::vector<Requirement>& requirements, vm::Object object) {
  std::vector<Requirement> all = requirements;
  for (const runtime::Expectation& expectation : scenario.expectations) {
    all.push_back({Scope::kFinal, expectation.text(), expectation.place});
  }
  runtime::ScenarioErrors errors;
  runtime::Controller controller(runtime::CardOptions(scenario));
  auto started = runtime::StartScenario(scenario, std::move(object), &controller, &errors);
  if (!started.ok()) return started.error();
  runtime::TraceQuantities(scenario, controller, &errors);
  SyncCells sync = runtime::SyncGlobals(scenario, controller.machine().image()->object, &errors);
  auto model = Model::Create(controller.machine());
  if (!model.ok()) {
    // Binding a thread may have failed: the other problems are reported all the same.
    runtime::ReadRequirements<runtime::CardCondition>(all, controller, &errors);
    if (auto failure = errors.Failure()) return *std::move(failure);
    return model.error();
  }
  runtime::CheckTimes(all, scenario, controller.machine().image()->object, &errors);
  Problem problem = BindProblem(std::move(model).value(), all, &errors);
  AddAsserts(runtime::ProgramPath(scenario), &problem, &errors);
  if (auto failure = errors.Failure()) return *std::move(failure);
  problem.sync = std::move(sync);
  problem.races = *RaceRuleNamed(scenario.races);
  problem.may_last = runtime::MayLastForEver(scenario);
  return problem;
}

Result<Findings> FollowSchedule(const runtime::Scenario& scenario,
                                const std::vector<Requirement>& requirements,
                                const vm::Object& object, std::string_view source,
                                const vm::Schedule& schedule) {
  const auto choices = runtime::Choices::Of(scenario);
  if (!choices.ok()) return choices.error();
  if (!choices.value().empty()) {
    return MakeError(1,
                     "a schedule is followed in one case, and the scenario leaves choices open: "
                     "write values in their place",
                     "跟随一个调度只对应一种情形，而场景留有选择：应写入确定的值");
  }
  const auto explore = [&](const Subject& subject, const auto& follow) -> Result<Exploration> {
    auto adapted = runtime::AdaptSchedule(scenario, object, source, schedule);
    if (!adapted.ok()) return adapted.error();
    Exploration exploration;
    exploration.engine = EngineKind::kFollow;
    exploration.verdict = Verdict::kPassed;
    exploration.why = MakeMessage(
        "no failure under this schedule (followed {0} of {1} segments); others were not tried",
        "在该调度下未出错（共 {1} 段，跟随了 {0} 段）；其它调度未尝试", adapted.value().followed,
        schedule.segments.size());
    FollowedRun run = follow(StepsOf(subject, adapted.value().schedule));
    if (run.failure.fault) {
      exploration.verdict = Verdict::kFailed;
      exploration.why = {};
      exploration.failure = std::move(run.failure);
    } else if (!run.ended && runtime::MayLastForEver(scenario)) {
      exploration.why = MakeMessage(
          "no failure in the first {0} statements of the run that begins with this schedule "
          "(followed {1} of {2} segments); others were not tried",
          "以该调度开始的运行在前 {0} 条语句内未出错（共 {2} 段，跟随了 {1} 段）；其它调度未尝试",
          run.failure.steps.size(), adapted.value().followed, schedule.segments.size());
    } else if (!run.ended) {
      exploration.verdict = Verdict::kIncomplete;
      exploration.why = {"the run that begins with this schedule does not end",
                         "以该调度开始的运行没有结束"};
    }
    return exploration;
  };
  if (runtime::NeedsCard(scenario, object)) {
    auto model = CardModel::Create(scenario, requirements, object);
    if (!model.ok()) return model.error();
    CardModel& card = model.value();
    auto exploration =
        explore(SubjectOf(card), [&](const auto& steps) { return TakeCardSteps(&card, steps); });
    if (!exploration.ok()) return exploration.error();
    BoundByHorizon(card.horizon(), &exploration.value());
    Findings findings = FindingsOf(scenario, &card, std::move(exploration).value());
    AddTrace(scenario, object, &findings);
    return findings;
  }
  const auto problem = ProblemOfScenario(scenario, requirements, object);
  if (!problem.ok()) return problem.error();
  auto exploration = explore(SubjectOf(problem.value()),
                             [&](const auto& steps) { return TakeSteps(problem.value(), steps); });
  if (!exploration.ok()) return exploration.error();
  return FindingsOf(scenario, problem.value(), std::move(exploration).value());
}

Result<runtime::Choices> ChoicesToExplore(const runtime::Scenario& scenario,
                                          const std::vector<Requirement>& requirements,
                                          const vm::Object& object) {
  if (!scenario.host.empty()) {
    return MakeError(1,
                     "a scenario with host events cannot be explored: start the threads with the "
                     "values that the host would write",
                     "带主机事件的场景无法探索：应在启动线程时就给出主机要写入的值");
  }
  runtime::PlacedErrors clashes;
  for (auto& [place, why] : runtime::ClashesWithEndless(scenario, requirements)) {
    clashes.Add(place, std::move(why));
  }
  if (auto failure = clashes.Failure()) return *std::move(failure);
  auto choices = runtime::Choices::Of(scenario);
  if (!choices.ok() || choices.value().empty()) return choices;
  // Every case must fit the program before the first one is searched.
  if (auto fits = runtime::CheckScenario(scenario, object); !fits.ok()) return fits.error();
  return choices;
}

Result<Findings> ExploreCase(const runtime::Scenario& chosen,
                             const std::vector<Requirement>& requirements, const vm::Object& object,
                             const ExploreOptions& options) {
  return runtime::NeedsCard(chosen, object) ? ExploreWithCard(chosen, requirements, object, options)
                                            : ExploreProgram(chosen, requirements, object, options);
}

Result<Findings> ExploreScenario(const runtime::Scenario& scenario,
                                 const std::vector<Requirement>& requirements,
                                 const vm::Object& object, const ExploreOptions& options) {
  const auto choices = ChoicesToExplore(scenario, requirements, object);
  if (!choices.ok()) return choices.error();
  if (choices.value().empty()) return ExploreCase(scenario, requirements, object, options);
  auto findings =
      ExploreCases(scenario, choices.value(), options,
                   [&](const runtime::Scenario& chosen, const ExploreOptions& chosen_options) {
                     return ExploreCase(chosen, requirements, object, chosen_options);
                   });
  if (findings.ok()) Describe(scenario, &findings.value().subject);
  return findings;
}

Result<Findings> ExploreAsWished(const runtime::Scenario& scenario, const vm::Object& object,
                                 std::string_view source, SearchProgress* progress) {
  const runtime::ExploreWish& wish = *scenario.explore;
  const std::vector<Requirement> requirements = RequirementsOf(scenario);
  if (wish.follow.empty()) {
    ExploreOptions options = OptionsOf(wish);
    options.progress = progress;
    return ExploreScenario(scenario, requirements, object, options);
  }
  const auto schedule = vm::LoadSchedule(runtime::PathFromScenario(scenario, wish.follow));
  if (!schedule.ok()) return schedule.error();
  return FollowSchedule(scenario, requirements, object, source, schedule.value());
}

}  // namespace oncard::explore
