#include "explore/explorer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#include "explore/card_graph.h"
#include "explore/dpor.h"
#include "explore/key_set.h"
#include "explore/races.h"
#include "explore/shrink.h"
#include "explore/state_graph.h"
#include "explore/walk.h"

namespace oncard::explore {
namespace {

constexpr std::array<std::pair<std::string_view, EngineKind>, 7> kEngines = {
    {{"auto", EngineKind::kAuto},
     {"dpor", EngineKind::kDpor},
     {"stateful", EngineKind::kStateful},
     {"bounded", EngineKind::kBounded},
     {"random", EngineKind::kRandom},
     {"pct", EngineKind::kPct},
     {"pos", EngineKind::kPos}}};

/// Empty for engines that search.
std::optional<SampleOptions> SamplingOf(const ExploreOptions& options) {
  SampleOptions sampling = {.runs = options.runs,
                            .seed = options.seed,
                            .depth = options.depth,
                            .statement_limit = options.depth_limit};
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
      break;
  }
  return std::nullopt;
}

/// The verdict of random schedules; the failure is left to the caller.
Exploration ConcludeSamples(EngineKind engine, SampleCounts samples) {
  Exploration exploration;
  exploration.engine = engine;
  exploration.verdict = samples.bad > 0 ? Verdict::kFailed : Verdict::kPassed;
  if (samples.bad == 0) {
    exploration.why = MakeMessage("none of {0} random schedules goes wrong; others were not tried",
                                  "{0} 个随机调度均未出错；其它调度未尝试", samples.runs);
  }
  exploration.samples = std::move(samples);
  return exploration;
}

BoundedOptions BoundsOf(const ExploreOptions& options) {
  return {.preemptions = options.preemption_limit,
          .statement_limit = options.depth_limit,
          .state_limit = options.state_limit};
}

/// The verdict of the schedules with few preemptions; the failure is left to the caller.
Exploration ConcludeBounded(BoundedCounts bounded, const ExploreOptions& options) {
  Exploration exploration;
  exploration.engine = EngineKind::kBounded;
  if (bounded.bad) {
    exploration.verdict = Verdict::kFailed;
  } else if (bounded.complete) {
    exploration.verdict = Verdict::kPassed;
    exploration.why = MakeMessage("no schedule with at most {0} preemptions goes wrong",
                                  "抢占不超过 {0} 次的调度均未出错", bounded.preemptions);
  } else {
    exploration.why = MakeMessage(
        "a limit was reached: {0} states, or {1} statements in one schedule",
        "已达到上限：{0} 个状态，或单个调度 {1} 条语句", options.state_limit, options.depth_limit);
  }
  exploration.bounded = std::move(bounded);
  return exploration;
}

/// `auto`: when one engine has an answer, the other may go on counting for this part of the time
/// that has passed, and at least for kGraceMin.
constexpr double kGracePart = 0.5;
constexpr std::chrono::milliseconds kGraceMin{20};

/// What the dpor engine found.
struct TraceSearch {
  TraceCounts counts;
  std::vector<uint8_t> failing;  ///< steps of the first execution that went wrong
};

/// What the stateful engine found.
struct StateSearch {
  StateCounts counts;
  StateGraph graph;
  std::vector<FoundRace> races;
};

/// Flags of states: a race that is not allowed; from the second on, that a requirement holds.
constexpr uint32_t kRacing = kCallersFlag;
constexpr uint32_t kFirstHolds = kCallersFlag << 1;

/// The flags of a state for the requirements of the scope kEventually, in their order.
uint32_t HoldingFlags(const Problem& problem, const Model& state) {
  uint32_t flags = 0;
  uint32_t flag = kFirstHolds;
  for (const BoundRequirement& requirement : problem.requirements) {
    if (requirement.scope != Scope::kEventually) continue;
    if (requirement.property.Holds(state)) flags |= flag;
    flag <<= 1;
  }
  return flags;
}

/// Looks for races in the states of a graph while it is built.
class RaceSearch {
 public:
  explicit RaceSearch(const Problem& problem) : problem_(problem) {}

  /// Told of the next state.
  void Look(const Model& state) {
    if (problem_.races != RaceRule::kAny) {
      for (const Race& race : FindRaces(state, problem_.sync)) states_[race].push_back(next_);
    }
    ++next_;
  }

  /// Flags the states with races that are not allowed. `end_of` as for ReachableEnds().
  std::vector<FoundRace> Finish(const std::vector<uint32_t>& end_of, StateGraph* graph) const {
    std::vector<uint32_t> ends;
    if (!states_.empty() && graph->complete) ends = ReachableEnds(*graph, end_of);
    std::vector<FoundRace> races;
    for (const auto& [race, states] : states_) {
      const bool benign = !ends.empty() && std::ranges::none_of(states, [&](uint32_t state) {
        return OrderMatters(*graph, ends, state, race);
      });
      races.push_back({race, benign});
      if (problem_.races == RaceRule::kBenign && (benign || !graph->complete)) continue;
      for (const uint32_t state : states) graph->flags[state] |= kRacing;
    }
    return races;
  }

 private:
  const Problem& problem_;
  std::map<Race, std::vector<uint32_t>> states_;  ///< that have it
  uint32_t next_ = 0;
};

TraceSearch SearchTraces(const Problem& problem, const ExploreOptions& options,
                         const std::atomic<bool>* stop) {
  TraceSearch search;
  Model model = problem.model;
  model.TrackKey(false);
  KeySet globals;
  KeySet full;
  DporLimits limits;
  limits.executions = options.execution_limit;
  limits.depth = options.depth_limit;
  limits.count_redundant = true;
  limits.stop = stop;
  ProgramWalk walk(problem);
  const auto goes_wrong = [&](const Model& state) {
    if (problem.races == RaceRule::kAny) return static_cast<bool>(FindFault(problem, state));
    walk.Restart();
    for (int64_t i = 0; i < state.depth() && !walk.fault(); ++i) walk.Step(state.StepThread(i));
    return static_cast<bool>(walk.fault());
  };
  const DporResult result = ExploreTraces(&model, limits, [&](const Model& state) {
    if (full.Insert(state.FinalKey())) globals.Insert(state.GlobalsKey());
    if (!goes_wrong(state)) return true;
    if (search.counts.bad_traces++ == 0) {
      for (int64_t i = 0; i < state.depth(); ++i) {
        search.failing.push_back(static_cast<uint8_t>(state.StepThread(i)));
      }
    }
    return true;
  });
  search.counts.executions = result.executions;
  search.counts.blocked = result.blocked;
  search.counts.redundant = result.redundant;
  search.counts.complete = result.complete;
  search.counts.final_globals = globals.size();
  search.counts.final_full = full.size();
  return search;
}

StateSearch SearchStates(const Problem& problem, const ExploreOptions& options,
                         const std::atomic<bool>* stop) {
  StateSearch search;
  Model model = problem.model;
  model.TrackKey(true);
  KeySet globals;
  KeySet full;
  RaceSearch races(problem);
  std::vector<uint32_t> final_of;  // of each terminal state, in order, the number of its globals
  std::vector<uint32_t> end_of;    // of each state, the number of its end if it is one
  search.graph = BuildStateGraph(&model, {options.state_limit, stop}, [&](const Model& state) {
    const bool bad = static_cast<bool>(FindFault(problem, state));
    uint32_t end = 0;
    if (state.runnable() == 0) {
      bool added = false;
      final_of.push_back(globals.FindOrAdd(state.GlobalsKey(), &added));
      end = full.FindOrAdd(state.FinalKey(), &added);
    }
    races.Look(state);
    if (problem.races != RaceRule::kAny) end_of.push_back(end);
    search.counts.bad_states += bad ? 1 : 0;
    return (bad ? kBad : 0u) | HoldingFlags(problem, state);
  });
  search.races = races.Finish(end_of, &search.graph);
  search.counts.states = search.graph.size();
  search.counts.transitions = search.graph.transitions;
  search.counts.final_globals = globals.size();
  search.counts.final_full = full.size();
  search.counts.complete = search.graph.complete;
  if (!search.counts.complete) return search;

  const std::vector<int> preemptions = PreemptionsTo(search.graph, kPreemptionBounds - 1);
  std::vector<int> fewest(globals.size(), kPreemptionBounds);
  size_t terminal = 0;
  for (uint32_t state = 0; state < search.graph.size(); ++state) {
    if ((search.graph.flags[state] & kTerminal) == 0) continue;
    int& best = fewest[final_of[terminal++]];
    best = std::min(best, preemptions[state]);
  }
  for (int bound = 0; bound < kPreemptionBounds; ++bound) {
    search.counts.finals_within.push_back(
        std::count_if(fewest.begin(), fewest.end(), [&](int least) { return least <= bound; }));
  }
  return search;
}

/// The way to a state with one of the flags; its fault is left to the caller.
std::optional<Failure> WayTo(const StateGraph& graph, uint32_t flag, uint32_t avoid = 0) {
  Path path = FewestPreemptions(graph, flag, avoid);
  if (!path.found) return std::nullopt;
  Failure failure;
  failure.steps = std::move(path.steps);
  failure.preemptions = path.preemptions;
  failure.fewest_preemptions = graph.complete;
  if (graph.complete && avoid == 0) {
    failure.fewest_steps = static_cast<int64_t>(FewestSteps(graph, flag).steps.size());
    failure.last_escape = LastEscape(graph, failure.steps);
  }
  return failure;
}

/// A run that ends without a state in which a requirement holds that must hold eventually.
std::optional<Failure> WayWithout(const Problem& problem, const StateGraph& graph) {
  uint32_t flag = kFirstHolds;
  for (size_t i = 0; i < problem.requirements.size(); ++i) {
    if (problem.requirements[i].scope != Scope::kEventually) continue;
    if (auto way = WayTo(graph, kTerminal, flag)) {
      way->fault = {Fault::Kind::kRequirement, static_cast<int>(i), 0};
      return way;
    }
    flag <<= 1;
  }
  return std::nullopt;
}

/// Takes the two statements of a race, at which the failure's steps have arrived.
void TakeRacingStatements(const Problem& problem, Failure* failure) {
  if (failure->fault.kind != Fault::Kind::kRace) return;
  Model model = problem.model;
  for (const uint8_t thread : failure->steps) model.Step(thread);
  for (const RacingStatement& racing : {failure->fault.race.first, failure->fault.race.second}) {
    if (!model.Running(racing.thread) || model.Position(racing.thread) != racing.position) continue;
    model.Step(racing.thread);
    failure->steps.push_back(static_cast<uint8_t>(racing.thread));
  }
  model = problem.model;
  failure->preemptions = CountPreemptions(&model, failure->steps);
}

/// Where the graph goes wrong: in a state, at the end of a run, for ever, or by a race; nothing
/// when it does not.
std::optional<Failure> FailureIn(const Problem& problem, const StateSearch& search) {
  const StateGraph& graph = search.graph;
  const auto walk_to_end = [&](const Failure& failure) {
    Model model = problem.model;
    for (const uint8_t thread : failure.steps) model.Step(thread);
    return model;
  };
  if (search.counts.bad_states > 0) {
    if (auto bad = WayTo(graph, kBad)) {
      bad->fault = FindFault(problem, walk_to_end(*bad));
      return bad;
    }
  }
  if (auto without = WayWithout(problem, graph)) return without;
  if (Lasso lasso = graph.complete ? FindFairCycle(graph) : Lasso{}; lasso.found) {
    Failure failure;
    failure.livelock = true;
    failure.steps = std::move(lasso.stem);
    failure.cycle = std::move(lasso.cycle);
    Model model = problem.model;
    failure.preemptions = CountPreemptions(&model, failure.steps);
    return failure;
  }
  if (search.races.empty()) return std::nullopt;
  auto racing = WayTo(graph, kRacing);
  if (!racing) return std::nullopt;
  racing->last_escape = -1;
  racing->fault.kind = Fault::Kind::kRace;
  for (const Race& race : FindRaces(walk_to_end(*racing), problem.sync)) {
    const auto found = std::ranges::find(search.races, race, &FoundRace::race);
    racing->fault.race = race;
    if (problem.races == RaceRule::kNone || !found->benign) break;
  }
  TakeRacingStatements(problem, &*racing);
  return racing;
}

Failure FailureOf(const Problem& problem, const std::vector<uint8_t>& steps) {
  Failure failure = Shrink(problem, steps);
  TakeRacingStatements(problem, &failure);
  return failure;
}

/// Runs both searches at the same time; each is told to stop some time after the other has an
/// answer.
void SearchBoth(const Problem& problem, const ExploreOptions& options,
                std::optional<TraceSearch>* traces, std::optional<StateSearch>* states,
                EngineKind* first) {
  std::mutex mutex;
  std::condition_variable answered;
  std::atomic<bool> stop{false};
  int running = 2;
  const auto start = std::chrono::steady_clock::now();
  const auto report = [&](EngineKind engine, bool complete) {
    const std::lock_guard lock(mutex);
    --running;
    if (complete && *first == EngineKind::kAuto) *first = engine;
    answered.notify_all();
  };
  std::thread tracing([&] {
    *traces = SearchTraces(problem, options, &stop);
    report(EngineKind::kDpor, (*traces)->counts.complete);
  });
  std::thread stating([&] {
    *states = SearchStates(problem, options, &stop);
    report(EngineKind::kStateful, (*states)->counts.complete);
  });
  {
    std::unique_lock lock(mutex);
    answered.wait(lock, [&] { return running == 0 || *first != EngineKind::kAuto; });
    const auto passed = std::chrono::steady_clock::now() - start;
    const auto grace = std::max<std::chrono::nanoseconds>(
        kGraceMin, std::chrono::duration_cast<std::chrono::nanoseconds>(passed * kGracePart));
    answered.wait_for(lock, grace, [&] { return running == 0; });
    stop = true;
  }
  tracing.join();
  stating.join();
}

Exploration Conclude(const Problem& problem, const ExploreOptions& options,
                     std::optional<TraceSearch> traces, std::optional<StateSearch> states,
                     EngineKind engine) {
  Exploration exploration;
  exploration.engine = engine;
  if (traces) exploration.traces = traces->counts;
  if (states) {
    exploration.failure = FailureIn(problem, *states);
    exploration.states = std::move(states->counts);
    exploration.races = std::move(states->races);
  }
  if (!exploration.failure && traces && !traces->failing.empty()) {
    exploration.failure = FailureOf(problem, traces->failing);
  }
  const bool complete =
      (traces && traces->counts.complete) || (exploration.states && exploration.states->complete);
  if (exploration.failure) {
    exploration.verdict = Verdict::kFailed;
  } else if (complete) {
    exploration.verdict = Verdict::kProved;
  } else {
    exploration.why = MakeMessage(
        "a limit was reached: {0} executions, {1} states, or {2} statements in one execution",
        "已达到上限：{0} 次执行、{1} 个状态，或单次执行 {2} 条语句", options.execution_limit,
        options.state_limit, options.depth_limit);
  }
  return exploration;
}

}  // namespace

std::optional<EngineKind> EngineNamed(std::string_view name) {
  for (const auto& [text, engine] : kEngines) {
    if (text == name) return engine;
  }
  return std::nullopt;
}

std::string_view EngineName(EngineKind engine) {
  for (const auto& [text, kind] : kEngines) {
    if (kind == engine) return text;
  }
  return {};
}

std::string_view VerdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::kProved:
      return "PROVED";
    case Verdict::kPassed:
      return "PASSED";
    case Verdict::kFailed:
      return "FAILED";
    case Verdict::kIncomplete:
      break;
  }
  return "INCOMPLETE";
}

Result<Exploration> Explore(const Problem& problem, const ExploreOptions& options) {
  if (problem.races == RaceRule::kBenign && options.engine != EngineKind::kAuto &&
      options.engine != EngineKind::kStateful) {
    return MakeError(1,
                     "whether a race is benign shows in the graph of all states only: use the "
                     "engine stateful",
                     "竞争是否无害只能由全部状态的图判定：请使用 stateful 引擎");
  }
  if (const auto sampling = SamplingOf(options)) {
    Exploration exploration = ConcludeSamples(options.engine, Sample(problem, *sampling));
    if (exploration.samples->bad > 0) {
      exploration.failure = FailureOf(problem, exploration.samples->failing);
    }
    return exploration;
  }
  if (options.engine == EngineKind::kBounded) {
    Exploration exploration = ConcludeBounded(SearchBounded(problem, BoundsOf(options)), options);
    if (exploration.bounded->bad) {
      exploration.failure = FailureOf(problem, exploration.bounded->failing);
      exploration.failure->fewest_preemptions = problem.races == RaceRule::kAny;
    }
    return exploration;
  }
  EngineKind engine = options.engine;
  if (engine == EngineKind::kAuto && problem.races != RaceRule::kAny) {
    engine = EngineKind::kStateful;
  }
  if (problem.HasInvariants()) {
    if (engine == EngineKind::kDpor) {
      return MakeError(
          1,
          "'always', 'never' and 'eventually' speak of states on the way, which traces pass over: "
          "use the engine stateful",
          "“always”、“never”和“eventually”涉及中间状态，而 dpor 引擎会跳过它们：请使用 stateful "
          "引擎");
    }
    engine = EngineKind::kStateful;
  }
  std::optional<TraceSearch> traces;
  std::optional<StateSearch> states;
  if (engine == EngineKind::kDpor) {
    traces = SearchTraces(problem, options, nullptr);
  } else if (engine == EngineKind::kStateful) {
    states = SearchStates(problem, options, nullptr);
  } else {
    SearchBoth(problem, options, &traces, &states, &engine);
  }
  return Conclude(problem, options, std::move(traces), std::move(states), engine);
}

Exploration ExploreCard(CardModel* model, const ExploreOptions& options) {
  if (const auto sampling = SamplingOf(options)) {
    Exploration exploration = ConcludeSamples(options.engine, SampleCard(model, *sampling));
    if (exploration.samples->bad > 0) {
      exploration.failure = ShrinkCard(model, exploration.samples->failing);
    }
    return exploration;
  }
  if (options.engine == EngineKind::kBounded) {
    Exploration exploration = ConcludeBounded(SearchCardBounded(model, BoundsOf(options)), options);
    if (exploration.bounded->bad) {
      exploration.failure = ShrinkCard(model, exploration.bounded->failing);
      exploration.failure->fewest_preemptions = true;
    }
    return exploration;
  }
  const CardGraph found = BuildCardGraph(model, {options.state_limit, nullptr});
  Exploration exploration;
  exploration.engine = EngineKind::kStateful;
  exploration.states = StateCounts{.states = found.graph.size(),
                                   .transitions = found.graph.transitions,
                                   .bad_states = found.bad_states,
                                   .final_globals = found.final_globals,
                                   .final_full = found.final_full,
                                   .finals_within = {},
                                   .complete = found.graph.complete};
  exploration.failure = WayTo(found.graph, kBad);
  if (exploration.failure) {
    CardWalk walk(model, false);
    for (const uint8_t thread : exploration.failure->steps) walk.Step(thread);
    exploration.failure->fault = walk.fault();
    exploration.verdict = Verdict::kFailed;
  } else if (!found.graph.complete) {
    exploration.why = MakeMessage("the limit of {0} states was reached", "已达到 {0} 个状态的上限",
                                  options.state_limit);
  } else if (found.cut) {
    exploration.verdict = Verdict::kPassed;
    exploration.why = {"nothing goes wrong until the scenario's until_ms; threads still run then",
                       "在场景的 until_ms 之前没有错误；此时仍有线程在运行"};
  } else {
    exploration.verdict = Verdict::kProved;
  }
  return exploration;
}

}  // namespace oncard::explore
