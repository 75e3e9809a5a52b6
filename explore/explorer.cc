#include "explore/explorer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "explore/card_graph.h"
#include "explore/dpor.h"
#include "explore/key_set.h"
#include "explore/shrink.h"
#include "explore/state_graph.h"

namespace oncard::explore {
namespace {

constexpr std::array<std::pair<std::string_view, EngineKind>, 6> kEngines = {
    {{"auto", EngineKind::kAuto},
     {"dpor", EngineKind::kDpor},
     {"stateful", EngineKind::kStateful},
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
  const DporResult result = ExploreTraces(&model, limits, [&](const Model& state) {
    if (full.Insert(state.FinalKey())) globals.Insert(state.GlobalsKey());
    if (!FindFault(problem, state)) return true;
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
  std::vector<uint32_t> final_of;  // of each terminal state, in order, the number of its globals
  search.graph = BuildStateGraph(&model, {options.state_limit, stop}, [&](const Model& state) {
    const bool bad = static_cast<bool>(FindFault(problem, state));
    if (state.runnable() == 0) {
      bool added = false;
      final_of.push_back(globals.FindOrAdd(state.GlobalsKey(), &added));
      full.Insert(state.FinalKey());
    }
    search.counts.bad_states += bad ? 1 : 0;
    return bad ? kBad : 0u;
  });
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

/// The way to a bad state of the graph; its fault is left to the caller.
std::optional<Failure> WayToBadState(const StateGraph& graph) {
  Path path = FewestPreemptions(graph, kBad);
  if (!path.found) return std::nullopt;
  Failure failure;
  failure.steps = std::move(path.steps);
  failure.preemptions = path.preemptions;
  failure.fewest_preemptions = graph.complete;
  if (graph.complete) {
    failure.fewest_steps = static_cast<int64_t>(FewestSteps(graph, kBad).steps.size());
    failure.last_escape = LastEscape(graph, failure.steps);
  }
  return failure;
}

/// A failing state of the graph, or a livelock; nothing when there is neither.
std::optional<Failure> FailureIn(const Problem& problem, const StateGraph& graph) {
  if (auto bad = WayToBadState(graph)) {
    Model model = problem.model;
    for (const uint8_t thread : bad->steps) model.Step(thread);
    bad->fault = FindFault(problem, model);
    return bad;
  }
  Failure failure;
  if (!graph.complete) return std::nullopt;
  if (Lasso lasso = FindFairCycle(graph); lasso.found) {
    failure.livelock = true;
    failure.steps = std::move(lasso.stem);
    failure.cycle = std::move(lasso.cycle);
    Model model = problem.model;
    failure.preemptions = CountPreemptions(&model, failure.steps);
    return failure;
  }
  return std::nullopt;
}

Failure FailureOf(const Problem& problem, const std::vector<uint8_t>& steps) {
  Failure failure;
  failure.steps = Shrink(problem, steps);
  Model model = problem.model;
  failure.preemptions = CountPreemptions(&model, failure.steps);
  for (const uint8_t thread : failure.steps) model.Step(thread);
  failure.fault = FindFault(problem, model);
  return failure;
}

/// A schedule as it is, with the fault that it leads to.
Failure FailureOfCard(CardModel* model, const std::vector<uint8_t>& steps) {
  Failure failure;
  failure.steps = steps;
  CardModel::State state = model->Start();
  for (size_t i = 0; i < steps.size(); ++i) {
    if (i > 0 && steps[i] != steps[i - 1] && (state.choices >> steps[i - 1] & 1) != 0) {
      ++failure.preemptions;
    }
    state = model->Step(state, steps[i]);
  }
  failure.fault = state.fault;
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
    exploration.states = std::move(states->counts);
    const bool looks_for_cycles = exploration.states->complete;
    if (exploration.states->bad_states > 0 || looks_for_cycles) {
      exploration.failure = FailureIn(problem, states->graph);
    }
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
  if (const auto sampling = SamplingOf(options)) {
    Exploration exploration = ConcludeSamples(options.engine, Sample(problem, *sampling));
    if (exploration.samples->bad > 0) {
      exploration.failure = FailureOf(problem, exploration.samples->failing);
    }
    return exploration;
  }
  EngineKind engine = options.engine;
  if (problem.HasInvariants()) {
    if (engine == EngineKind::kDpor) {
      return MakeError(
          1,
          "'always' and 'never' speak of states on the way, which traces pass over: "
          "use the engine stateful",
          "“always”和“never”涉及中间状态，而 dpor 引擎会跳过它们：请使用 stateful 引擎");
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
      exploration.failure = FailureOfCard(model, exploration.samples->failing);
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
  exploration.failure = WayToBadState(found.graph);
  if (exploration.failure) {
    exploration.failure->fault = FailureOfCard(model, exploration.failure->steps).fault;
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
