#include "explore/search/explorer.h"

#include <algorithm>
#include <atomic>

#include "base/milliseconds.h"
#include "explore/engines/card_cut.h"
#include "explore/engines/card_graph.h"
#include "explore/engines/estimate.h"
#include "explore/engines/first_look.h"
#include "explore/engines/shrink.h"
#include "explore/engines/walk.h"
#include "explore/search/search_pair.h"
#include "runtime/scenario/file/search_names.h"

namespace oncard::explore {
namespace {

static_assert(runtime::kEngineNames.size() == static_cast<size_t>(EngineKind::kFollow));
static_assert(runtime::kVerdictNames.size() == static_cast<size_t>(Verdict::kIncomplete) + 1);

const std::atomic<bool>* StopOf(const ExploreOptions& options) {
  return options.progress == nullptr ? nullptr : &options.progress->stop;
}

/// Empty for engines that search.
std::optional<SampleOptions> SamplingOf(const ExploreOptions& options) {
  SampleOptions sampling = {.runs = options.runs,
                            .first_run = options.first_run,
                            .seed = options.seed,
                            .depth = options.depth,
                            .statement_limit = options.depth_limit,
                            .stop = StopOf(options),
                            .progress = options.progress};
  switch (options.engine) {
    case EngineKind::kRandom:
      sampling.kind = SamplerKind::kRandom;
      return sampling;
    case EngineKind::kPct:
      sampling.kind = SamplerKind::kPct;
      return sampling;
    case EngineKind::kPos:
      sampling.kind = SamplerKind::kPos;
      return sampling;
    case EngineKind::kAuto:
    case EngineKind::kDpor:
    case EngineKind::kStateful:
    case EngineKind::kBounded:
    case EngineKind::kFollow:
      break;
  }
  return std::nullopt;
}

BoundedOptions BoundsOf(const ExploreOptions& options) {
  return {.preemptions = options.preemption_limit,
          .statement_limit = options.depth_limit,
          .state_limit = options.state_limit,
          .stop = StopOf(options)};
}

/// The verdict of the schedules with few preemptions; the caller fills in the failure.
Exploration ConcludeBounded(BoundedCounts bounded, const ExploreOptions& options) {
  Exploration exploration;
  exploration.engine = EngineKind::kBounded;
  if (bounded.bad) {
    exploration.verdict = Verdict::kFailed;
  } else if (bounded.complete) {
    exploration.verdict = Verdict::kPassed;
    exploration.why = DescribeBound(bounded);
  } else {
    exploration.why =
        WhyIncomplete(options, MakeMessage("a limit was reached: {0} states, or {1} "
                                           "statements in one schedule",
                                           "已达到上限：{0} 个状态，或单个调度 {1} 条语句",
                                           options.state_limit, options.depth_limit));
  }
  exploration.ends = bounded.ends.ends();
  exploration.coverage = bounded.coverage;
  exploration.bounded = std::move(bounded);
  return exploration;
}

/// How far a search continues after the first failure: far enough for complete counts of a small
/// program. `auto` already shows what its first look has found, so it continues for less.
struct Aftermath {
  int64_t statements = 0;  ///< of executions (TraceSearchLimits)
  uint32_t states = 0;
  uint32_t card_states = 0;
};
constexpr Aftermath kAftermath = {100'000'000, 4'000'000, 200'000};
constexpr Aftermath kShortAftermath = {10'000'000, 500'000, 5000};

const Aftermath& AftermathOf(const ExploreOptions& options) {
  static constexpr Aftermath kAll = {INT64_MAX, ~uint32_t{0}, ~uint32_t{0}};
  if (options.all || options.begun != nullptr) return kAll;
  return options.engine == EngineKind::kAuto ? kShortAftermath : kAftermath;
}

/// The number of traces is estimated with this many descents, each limited to this many statements.
constexpr int kDescents = 1000;
constexpr int64_t kDescentDepth = 10'000;

/// The search of traces, continued from ExploreOptions::begun if it is set. `takes_pause` returns
/// true if it was stopped only so that its progress can be kept.
TraceSearch TracesOf(const Problem& problem, const ExploreOptions& options,
                     const std::atomic<bool>* stop, const std::function<bool()>& takes_pause) {
  TraceSearch search = options.begun == nullptr ? TraceSearch{} : *options.begun;
  int64_t left = options.execution_limit;
  for (;;) {
    const int64_t before = search.executions;
    SearchTraces(problem,
                 {.executions = left,
                  .depth = options.depth_limit,
                  .statements_after_bad = AftermathOf(options).statements,
                  .counts = options.engine == EngineKind::kAuto && options.begun == nullptr &&
                            options.execution_limit >= ExploreOptions{}.execution_limit,
                  .stop = stop,
                  .progress = options.progress},
                 &search);
    left -= search.executions - before;
    // Ended: nothing is left, a failure was found, or the limit was reached.
    const bool over = search.units.empty() || search.bad > 0 || left <= 0;
    if (!options.keep || !takes_pause() || over) return search;
    options.keep(search);
  }
}

StateLimits StatesOf(const ExploreOptions& options, const std::atomic<bool>* stop) {
  return {.states = options.state_limit,
          .states_after_bad = AftermathOf(options).states,
          .merge_private = options.merge_private == true,
          .dead_locals = options.dead_locals,
          .symmetry = options.symmetry,
          .known_steps = options.known_steps,
          .stop = stop,
          .progress = options.progress};
}

/// The failure to show: the simplest one if all states are known, otherwise the one that was found
/// first in an order that depends on the clock as little as possible.
std::optional<Failure> FailureOf(const Problem& problem, const FirstLook& look,
                                 const std::optional<TraceSearch>& traces,
                                 const std::optional<StateSearch>& states,
                                 const std::atomic<bool>* hurried) {
  if (states && states->counts.complete) {
    if (auto failure = FailureIn(problem, *states, hurried)) return failure;
  }
  if (look.found()) {
    Failure failure = Shrink(problem, look.failing, hurried);
    failure.fewest_preemptions = look.fewest_preemptions;
    return failure;
  }
  if (states && !states->counts.complete) {
    auto failure = FailureIn(problem, *states, hurried);
    if (failure && failure->fault.kind == Fault::Kind::kRace) return failure;
    if (failure) return Shrink(problem, failure->steps, hurried);
  }
  if (traces && !traces->failing.empty()) {
    return ShrinkExecution(problem, traces->failing, hurried);
  }
  return std::nullopt;
}

/// What a search has executed, by what does not depend on the clock as far as possible: the engine
/// that is complete knows all, and beside a failure the states are searched to their end.
StatementCoverage CoverageOf(const FirstLook& look, const std::optional<TraceSearch>& traces,
                             const std::optional<StateSearch>& states, bool failed) {
  if (states && (states->counts.complete || failed)) return states->coverage;
  if (traces && (traces->complete() || !states)) return traces->coverage;
  StatementCoverage coverage = states ? states->coverage : StatementCoverage();
  if (traces) coverage.Include(traces->coverage);
  if (!look.coverage.empty()) coverage.Include(look.coverage);
  return coverage;
}

/// Adds the statements of a failure, which another search may have found.
void IncludeFailure(const Problem& problem, Exploration* exploration) {
  if (!exploration->failure || exploration->coverage.empty()) return;
  Model model = problem.model;
  model.NoteIn(&exploration->coverage);
  for (const std::vector<uint8_t>* steps :
       {&exploration->failure->steps, &exploration->failure->cycle}) {
    for (const uint8_t thread : *steps) model.Step(thread);
  }
}

Exploration Conclude(const Problem& problem, const ExploreOptions& options, const FirstLook& look,
                     std::optional<TraceSearch> traces, std::optional<StateSearch> states,
                     EngineKind engine) {
  Exploration exploration;
  exploration.engine = engine;
  if (traces) exploration.traces = traces->Counts();
  exploration.failure = FailureOf(problem, look, traces, states, HurriedOf(options.progress));
  if (options.begun == nullptr) {
    exploration.coverage = CoverageOf(look, traces, states, exploration.failure.has_value());
  }
  if (traces) exploration.ends = traces->ends.ends();
  if (states) {
    if (states->counts.complete || !traces) exploration.ends = states->ends.ends();
    exploration.states = std::move(states->counts);
    exploration.races = std::move(states->races);
  }
  // What is not in a single state may have been missed in a hurry.
  const bool stated =
      exploration.states && exploration.states->complete && !IsTold(HurriedOf(options.progress));
  const bool complete = (traces && traces->complete()) || stated;
  if (exploration.failure) {
    exploration.verdict = Verdict::kFailed;
  } else if (complete) {
    exploration.verdict = Verdict::kProved;
  } else {
    exploration.why = WhyIncomplete(options, DescribeLimits(options));
  }
  if (traces) exploration.search = std::move(*traces);
  return exploration;
}

/// For what is required of every state, kAuto searches the graph of states alone if it has fewer
/// than this.
constexpr uint32_t kStatesAlone = 500'000;

/// Searches that graph. True: the search of traces is not needed, as the graph is small, has a
/// failure, or the search was stopped; `states` then has it if it is all that is to be searched.
bool SearchFewStates(const Problem& problem, const ExploreOptions& options,
                     std::optional<StateSearch>* states) {
  StateLimits limits = StatesOf(options, StopOf(options));
  limits.states = std::min(limits.states, kStatesAlone);
  StateSearch few = SearchStates(problem, limits);
  const bool enough = few.counts.complete || IsTold(limits.stop);
  const bool bad = few.counts.bad_states > 0;
  if (enough) *states = std::move(few);
  return enough || bad;
}

/// Replaces a failure that was found in merged statements, and what was counted, by those of the
/// graph of single statements, if that is small.
void ShowInSingleStatements(const Problem& problem, const ExploreOptions& options,
                            Exploration* exploration) {
  if (!exploration->failure || !exploration->states || !exploration->states->merged) return;
  ExploreOptions single = options;
  single.merge_private = false;
  single.state_limit =
      std::min({options.state_limit, AftermathOf(options).states, kAftermath.states});
  StateSearch states = SearchStates(problem, StatesOf(single, StopOf(options)));
  if (!states.counts.complete) return;
  auto failure = FailureIn(problem, states, HurriedOf(options.progress));
  if (!failure) return;
  exploration->failure = std::move(failure);
  exploration->ends = states.ends.ends();
  exploration->states = std::move(states.counts);
  exploration->races = std::move(states.races);
  exploration->coverage = std::move(states.coverage);
}

}  // namespace

std::optional<EngineKind> EngineNamed(std::string_view name) {
  const auto found = std::ranges::find(runtime::kEngineNames, name);
  if (found == runtime::kEngineNames.end()) return std::nullopt;
  return static_cast<EngineKind>(found - runtime::kEngineNames.begin());
}

std::string_view EngineName(EngineKind engine) {
  return engine == EngineKind::kFollow ? "schedule"
                                       : runtime::kEngineNames[static_cast<size_t>(engine)];
}

std::string_view VerdictName(Verdict verdict) {
  return runtime::kVerdictNames[static_cast<size_t>(verdict)];
}

Message WhyIncomplete(const ExploreOptions& options, Message limit) {
  if (options.progress != nullptr && options.progress->stop) {
    if (options.progress->out_of_memory) return {"the memory limit was reached", "内存已到上限"};
    return options.progress->out_of_time ? Message{"the time limit was reached", "时间已到"}
                                         : Message{"it was interrupted", "已中断"};
  }
  return limit;
}

Message DescribeSamples(const SampleCounts& samples) {
  return MakeMessage("none of {0} random schedules fails; others were not tried",
                     "{0} 个随机调度均未出错；其它调度未尝试", samples.runs);
}

Message DescribeBound(const BoundedCounts& bounded) {
  return MakeMessage("no schedule with at most {0} preemptions fails",
                     "抢占不超过 {0} 次的调度均未出错", bounded.preemptions);
}

Message DescribeLimits(const ExploreOptions& options) {
  return MakeMessage(
      "a limit was reached: {0} executions, {1} states, or {2} statements in one execution",
      "已达到上限：{0} 次执行、{1} 个状态，或单次执行 {2} 条语句", options.execution_limit,
      options.state_limit, options.depth_limit);
}

Exploration ConcludeSamples(EngineKind engine, SampleCounts samples) {
  Exploration exploration;
  exploration.engine = engine;
  exploration.verdict = samples.bad > 0 ? Verdict::kFailed : Verdict::kPassed;
  if (samples.bad == 0) exploration.why = DescribeSamples(samples);
  exploration.ends = samples.values.ends();
  exploration.coverage = samples.coverage;
  exploration.samples = std::move(samples);
  return exploration;
}

std::optional<Message> WhyNotMerged(const Problem& problem) {
  const auto sees_threads = [](const BoundRequirement& requirement) {
    if (requirement.scope == Scope::kFinal || requirement.scope == Scope::kAssert) return false;
    return !requirement.property.SeesGlobalsAlone() ||
           (requirement.then && !requirement.then->SeesGlobalsAlone());
  };
  if (std::ranges::any_of(problem.requirements, sees_threads)) {
    return MakeMessage(
        "'always', 'never', 'eventually' and 'leads' cannot name locals or results of threads when "
        "statements that touch only locals are merged",
        "合并只涉及局部变量的语句时，“always”、“never”、“eventually”和“leads”不能引用局部变量或"
        "线程的返回值");
  }
  if (problem.model.ChecksAreLocal()) return std::nullopt;
  return MakeMessage(
      "an assert names another thread's local or result, or more than {0} globals: statements that "
      "touch only locals cannot be merged",
      "断言引用了其他线程的局部变量或返回值，或超过 {0} 个全局变量：不能合并只涉及局部变量的语句",
      AccessSet::kCheckedMax);
}

Result<Exploration> Explore(const Problem& problem, const ExploreOptions& options) {
  if (problem.races == RaceRule::kBenign && options.engine != EngineKind::kAuto &&
      options.engine != EngineKind::kStateful) {
    return MakeError(
        1, "only the graph of all states shows whether a race is benign: use the engine stateful",
        "竞争是否无害只能由全部状态的图判定：请使用 stateful 引擎");
  }
  const bool asks_for_responses =
      std::ranges::find(problem.requirements, Scope::kLeads, &BoundRequirement::scope) !=
      problem.requirements.end();
  if (options.engine == EngineKind::kDpor && asks_for_responses) {
    return MakeError(1,
                     "'leads' concerns intermediate states, which the engine dpor skips: use the "
                     "engine stateful",
                     "“leads”涉及中间状态，而 dpor 引擎会跳过它们：请使用 stateful 引擎");
  }
  const auto unmergeable = WhyNotMerged(problem);
  if (options.merge_private == true && unmergeable) return Error{1, *unmergeable};
  if (const auto sampling = SamplingOf(options)) {
    Exploration exploration = ConcludeSamples(options.engine, Sample(problem, *sampling));
    if (exploration.samples->bad > 0) {
      exploration.failure =
          Shrink(problem, exploration.samples->failing, HurriedOf(options.progress));
    }
    return exploration;
  }
  if (options.engine == EngineKind::kBounded) {
    Exploration exploration = ConcludeBounded(SearchBounded(problem, BoundsOf(options)), options);
    if (exploration.bounded->bad) {
      exploration.failure =
          Shrink(problem, exploration.bounded->failing, HurriedOf(options.progress));
      exploration.failure->fewest_preemptions = problem.races == RaceRule::kAny;
    }
    return exploration;
  }
  EngineKind engine = options.engine;
  if (engine == EngineKind::kAuto && problem.races != RaceRule::kAny) {
    engine = EngineKind::kStateful;
  }
  if (!CanSearchTraces(problem)) {
    if (engine == EngineKind::kDpor) {
      return MakeError(
          1,
          "the engine dpor checks 'always' and 'never' that name at most {0} globals, and asserts "
          "that name these or locals of their own thread: for others and for 'eventually' use the "
          "engine stateful",
          "dpor 引擎只检查引用不超过 {0} 个全局变量的“always”和“never”，以及只引用这些变量或"
          "自身线程局部变量的断言：其他条件和“eventually”请使用 stateful 引擎",
          AccessSet::kCheckedMax);
    }
    engine = EngineKind::kStateful;
  }
  if (options.progress != nullptr && options.progress->estimates &&
      engine != EngineKind::kStateful) {
    Model model = ModelOfTraces(problem);
    const TraceEstimate estimate =
        EstimateTraces(&model, kDescents, options.seed, kDescentDepth, StopOf(options));
    options.progress->expected = estimate.traces;
    options.progress->expected_error = estimate.error;
  }
  FirstLook look;
  if (options.engine == EngineKind::kAuto && !options.all && options.begun == nullptr) {
    look = LookFirst(problem, StopOf(options), options.cases);
  }
  std::optional<TraceSearch> traces;
  std::optional<StateSearch> states;
  ExploreOptions searched = options;
  if (!options.merge_private) searched.merge_private = !unmergeable && !look.found();
  if (look.found()) {
    searched.state_limit = std::min(options.state_limit, AftermathOf(options).states);
  }
  if (engine == EngineKind::kAuto && problem.HasInvariants() &&
      (look.found() || SearchFewStates(problem, searched, &states))) {
    engine = EngineKind::kStateful;
  }
  const bool paired = engine == EngineKind::kAuto;
  if (engine == EngineKind::kDpor) {
    traces = TracesOf(problem, searched, StopOf(options),
                      [&] { return options.progress != nullptr && options.progress->TakePause(); });
  } else if (engine == EngineKind::kStateful) {
    if (!states) states = SearchStates(problem, StatesOf(searched, StopOf(options)));
  } else {
    PairResult both =
        RunPair({.traces =
                     [&](const std::atomic<bool>* stop, const SearchPair::TakesPause& takes_pause) {
                       return TracesOf(problem, searched, stop, takes_pause);
                     },
                 .states =
                     [&](const std::atomic<bool>* stop, const std::atomic<uint32_t>* most) {
                       StateLimits limits = StatesOf(searched, stop);
                       limits.most_while_good = most;
                       return SearchStates(problem, limits);
                     },
                 .known_bad = look.found(),
                 .progress = options.progress});
    if (both.first == PairResult::First::kTraces) engine = EngineKind::kDpor;
    if (both.first == PairResult::First::kStates) engine = EngineKind::kStateful;
    traces = std::move(both.traces);
    states = std::move(both.states);
  }
  Exploration exploration =
      Conclude(problem, options, look, std::move(traces), std::move(states), engine);
  exploration.paired = paired;
  if (!options.merge_private) ShowInSingleStatements(problem, options, &exploration);
  IncludeFailure(problem, &exploration);
  return exploration;
}

namespace {

/// What `auto` does last where a card has too many states: so many random schedules, which do not
/// depend on the clock.
constexpr int64_t kLastRuns = 1000;
constexpr int64_t kLastStatements = 1'000'000;

void TryAtRandom(CardModel* model, const ExploreOptions& options, Exploration* exploration) {
  const SampleCounts tried = SampleCard(model, {.kind = SamplerKind::kPos,
                                                .runs = kLastRuns,
                                                .seed = options.seed,
                                                .statement_limit = options.depth_limit,
                                                .all_statements = kLastStatements,
                                                .until_bad = true,
                                                .stop = StopOf(options)});
  if (tried.bad > 0) {
    exploration->failure = ShrinkCard(model, tried.failing, HurriedOf(options.progress));
    exploration->verdict = Verdict::kFailed;
    exploration->engine = EngineKind::kPos;
    exploration->why = {};
    return;
  }
  const Message more = MakeMessage("; none of {0} random schedules of the engine pos fails",
                                   "；pos 引擎的 {0} 个随机调度均未出错", tried.runs);
  exploration->why = {exploration->why.en + more.en, exploration->why.zh + more.zh};
}

/// Below so many states `auto` reports those of the card even if there is a proof by fewer: the
/// counts of small programs are exact, and so are their ends. Cases share them.
constexpr int64_t kStatesBesideProof = 5000;

IslandResult SearchIslands(CardModel* model, const ExploreOptions& options,
                           const StateLimits& limits) {
  if (options.engine != EngineKind::kAuto || !options.islands || options.all) return {};
  // What is asked of nothing shows all results, which are no sum of those of the islands.
  if (model->asks_nothing()) return {};
  auto islands = Islands::Of(*model);
  return islands ? ProveByIslands(model, *std::move(islands), limits) : IslandResult{};
}

std::optional<ReducedSearch> SearchWithReductions(CardModel* model, const ExploreOptions& options,
                                                  const StateLimits& limits) {
  if (options.engine != EngineKind::kAuto || !options.reductions || options.all) {
    return std::nullopt;
  }
  return SearchReduced(model, limits);
}

Reached ReachedAt(CardModel* model, const CardModel::State& state) {
  model->Load(state);
  const runtime::Controller& card = model->controller();
  const vm::Machine& machine = card.machine();
  // The statements of a cycle are executed before the run can end with it.
  const int64_t complete = std::max<int64_t>(card.cycle() - 1, 0);
  Reached reached = {card.NowMs(), ToMs(card.clock().UsOf(complete)), {}};
  for (const ThreadSetup& setup : model->setups()) {
    const bool runs = machine.thread(setup.thread).run == vm::ThreadRun::kRunning;
    reached.lines.push_back(runs ? machine.Line(setup.thread) : 0);
  }
  return reached;
}

Message DescribeStateLimit(const ExploreOptions& options) {
  return MakeMessage("the limit of {0} states was reached", "已达到 {0} 个状态的上限",
                     options.state_limit);
}

/// Each group begins in so many different states, if there are as many, so that all groups take
/// about the same time.
constexpr size_t kStartsOfGroup = 16;
/// At most so many states are searched to find them, in every group.
constexpr uint32_t kStatesBeforeGroups = 5000;

/// One of ExploreOptions::groups.
Exploration SearchGroup(CardModel* model, const ExploreOptions& options) {
  StateLimits limits = StatesOf(options, StopOf(options));
  limits.states_after_bad = AftermathOf(options).card_states;
  limits.states = kStatesBeforeGroups;
  const auto groups = static_cast<size_t>(options.groups);
  CardCut cut = CutCard(model, kStartsOfGroup * groups, limits);
  limits.states = options.state_limit;
  Exploration exploration;
  exploration.engine = EngineKind::kStateful;
  EndSet ends;
  StateCounts& counts = exploration.states.emplace();
  if (options.group == 0) {
    counts = cut.counts;
    ends = cut.ends;
  }
  counts.in_groups = true;
  counts.complete = cut.counts.complete;
  const auto fail = [&](const std::vector<uint8_t>& steps) {
    exploration.failure = ShrinkCard(model, steps, HurriedOf(options.progress));
    exploration.verdict = Verdict::kFailed;
  };
  // Neighbours are similar, so that they share what follows: measured with a thread that polls for
  // an axis and one that polls for a variable, 4 groups of neighbours have 2.4 times as many states
  // as the whole, and 4 groups of every fourth state 3.9 times.
  const auto start_of = [&](int group) {
    return cut.starts.size() * static_cast<size_t>(group) / groups;
  };
  const size_t first = start_of(options.group);
  const std::vector<CardModel::State> starts(
      cut.starts.begin() + static_cast<std::ptrdiff_t>(first),
      cut.starts.begin() + static_cast<std::ptrdiff_t>(start_of(options.group + 1)));
  if (cut.fails) {
    fail(cut.failing);
  } else if (cut.counts.complete && !starts.empty()) {
    const CardGraph found = BuildCardGraph(model, limits, starts);
    exploration.remembers_steps = found.by_rows;
    counts.states += found.graph.size();
    counts.transitions += found.graph.transitions;
    counts.bad_states += found.bad_states;
    counts.final_globals += found.final_globals;
    counts.final_full += found.final_full;
    counts.complete = found.graph.complete;
    for (const End& end : found.ends.ends()) ends.Add(end);
    if (found.bad_states > 0) {
      const Path path = FewestSteps(found.graph, kBad, static_cast<uint32_t>(starts.size()));
      std::vector<uint8_t> steps = cut.ways[first + path.start];
      steps.insert(steps.end(), path.steps.begin(), path.steps.end());
      fail(steps);
    } else if (found.open) {
      exploration.reached = ReachedAt(model, *found.open);
    }
  }
  exploration.ends = ends.ends();
  if (exploration.failure) return exploration;
  if (!counts.complete) {
    exploration.why = WhyIncomplete(options, DescribeStateLimit(options));
  } else {
    exploration.verdict = model->horizon() ? Verdict::kPassed : Verdict::kProved;
  }
  return exploration;
}

Exploration SearchCard(CardModel* model, const ExploreOptions& options) {
  if (const auto sampling = SamplingOf(options)) {
    Exploration exploration = ConcludeSamples(options.engine, SampleCard(model, *sampling));
    if (exploration.samples->bad > 0) {
      exploration.failure =
          ShrinkCard(model, exploration.samples->failing, HurriedOf(options.progress));
    }
    return exploration;
  }
  if (options.engine == EngineKind::kBounded) {
    Exploration exploration = ConcludeBounded(SearchCardBounded(model, BoundsOf(options)), options);
    if (exploration.bounded->bad) {
      exploration.failure =
          ShrinkCard(model, exploration.bounded->failing, HurriedOf(options.progress));
      exploration.failure->fewest_preemptions = true;
    }
    return exploration;
  }
  if (options.groups > 1) return SearchGroup(model, options);
  FirstLook look;
  if (options.engine == EngineKind::kAuto && !options.all) {
    look = LookFirstAtCard(model, StopOf(options), options.cases);
  }
  StateLimits limits = StatesOf(options, StopOf(options));
  limits.states_after_bad = AftermathOf(options).card_states;
  std::optional<IslandProof> proof;
  std::optional<ReducedSearch> reduced;
  if (!look.found()) {
    IslandResult islands = SearchIslands(model, options, limits);
    proof = std::move(islands.proof);
    look.failing = std::move(islands.failing);
  }
  if (!look.found() && !proof) reduced = SearchWithReductions(model, options, limits);
  if (reduced && reduced->fails) look.failing = reduced->failing;
  if (look.found()) {
    limits.states = std::min(limits.states, limits.states_after_bad);
  } else if (proof || reduced) {
    const auto beside = static_cast<uint32_t>(kStatesBesideProof / options.cases);
    limits.states = std::min(limits.states, beside);
  }
  const CardGraph found = BuildCardGraph(model, limits);
  Exploration exploration;
  exploration.engine = EngineKind::kStateful;
  exploration.remembers_steps = found.by_rows;
  if (proof && !found.graph.complete) {
    proof->IncludeIn(model);
    exploration.islands = std::move(proof->counts);
  }
  const bool left_out = reduced && !reduced->fails && !found.graph.complete;
  if (left_out) exploration.reduced = reduced->counts;
  exploration.states = StateCounts{.states = found.graph.size(),
                                   .transitions = found.graph.transitions,
                                   .bad_states = found.bad_states,
                                   .final_globals = found.final_globals,
                                   .final_full = found.final_full,
                                   .finals_within = {},
                                   .complete = found.graph.complete};
  exploration.ends = left_out ? reduced->ends.ends() : found.ends.ends();
  if (found.bad_states > 0) exploration.failure = WayTo(found.graph, kBad);
  if (exploration.failure && found.graph.complete) {
    CardWalk walk(model, false);
    for (const uint8_t thread : exploration.failure->steps) walk.Step(thread);
    exploration.failure->fault = walk.fault();
  } else if (look.found()) {
    exploration.failure = look.failure
                              ? std::move(look.failure)
                              : ShrinkCard(model, look.failing, HurriedOf(options.progress));
    exploration.failure->fewest_preemptions = look.fewest_preemptions;
  } else if (exploration.failure) {
    exploration.failure =
        ShrinkCard(model, exploration.failure->steps, HurriedOf(options.progress));
  }
  if (exploration.failure) {
    exploration.verdict = Verdict::kFailed;
  } else if (!found.graph.complete && !exploration.islands && !(left_out && reduced->complete)) {
    exploration.why = WhyIncomplete(options, DescribeStateLimit(options));
    const std::optional<CardModel::State>& open = left_out ? reduced->open : found.open;
    if (open) exploration.reached = ReachedAt(model, *open);
    const bool last_way = options.engine == EngineKind::kAuto && !IsTold(StopOf(options));
    if (last_way) TryAtRandom(model, options, &exploration);
  } else if (model->horizon()) {
    exploration.verdict = Verdict::kPassed;
  } else {
    exploration.verdict = Verdict::kProved;
  }
  return exploration;
}

}  // namespace

void BoundByHorizon(const Horizon& horizon, Exploration* exploration) {
  if (exploration->verdict != Verdict::kPassed || !horizon) return;
  exploration->horizon = horizon;
  const Message bound = DescribeHorizon(horizon);
  Message& why = exploration->why;
  why = why.en.empty() ? Message{"no failure " + bound.en, "未出错，" + bound.zh}
                       : Message{why.en + "; " + bound.en, why.zh + "；" + bound.zh};
}

Exploration ExploreCard(CardModel* model, const ExploreOptions& options) {
  Exploration exploration = SearchCard(model, options);
  exploration.coverage = model->coverage();
  for (const Race& race : model->races_met()) exploration.races.push_back({race, false});
  BoundByHorizon(model->horizon(), &exploration);
  return exploration;
}

}  // namespace oncard::explore
