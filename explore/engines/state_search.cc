#include "explore/engines/state_search.h"

#include <algorithm>
#include <map>
#include <utility>

#include "explore/engines/reachable_ends.h"
#include "explore/engines/shrink.h"
#include "explore/models/equal_threads.h"
#include "explore/models/key_set.h"
#include "explore/models/thread_future.h"

namespace oncard::explore {
namespace {

/// Flags of states: a race that is not allowed; the following ones say that a requirement holds.
constexpr uint32_t kRacing = kCallersFlag;
constexpr uint32_t kFirstHolds = kCallersFlag << 1;

/// The flags for the requirements with the scopes kEventually and kLeads, in their order: one for
/// each condition.
uint32_t HoldingFlags(const Problem& problem, const Model& state) {
  uint32_t flags = 0;
  uint32_t flag = kFirstHolds;
  const auto note = [&](const Property& property) {
    if (property.Holds(state)) flags |= flag;
    flag <<= 1;
  };
  for (const BoundRequirement& requirement : problem.requirements) {
    if (requirement.scope != Scope::kEventually && requirement.scope != Scope::kLeads) continue;
    note(requirement.property);
    if (requirement.then) note(*requirement.then);
  }
  return flags;
}

/// Calls `visit` with each requirement under a scope, and the first of its flags.
template <typename Visit>
void ForEachFlagged(const Problem& problem, Scope scope, Visit visit) {
  uint32_t flag = kFirstHolds;
  for (size_t i = 0; i < problem.requirements.size(); ++i) {
    const Scope own = problem.requirements[i].scope;
    if (own == scope) visit(static_cast<int>(i), flag);
    if (own == Scope::kEventually) flag <<= 1;
    if (own == Scope::kLeads) flag <<= 2;
  }
}

/// Finds races in the states of a graph while it is built.
class RaceSearch {
 public:
  explicit RaceSearch(const Problem& problem) : problem_(problem) {}

  /// Examines the next state for races.
  void Examine(const Model& state) {
    if (problem_.races != RaceRule::kAny) {
      for (const Race& race : FindRaces(state, problem_.sync)) states_[race].push_back(next_);
    }
    ++next_;
  }

  /// Flags the states with races that are not allowed. `end_of` as for ReachableEnds().
  /// The graph counts as incomplete if `hurried` was set before that was known.
  std::vector<FoundRace> Finish(const std::vector<uint32_t>& end_of,
                                const std::atomic<bool>* hurried, StateGraph* graph) const {
    std::vector<uint32_t> ends;
    if (!states_.empty() && graph->complete) {
      ends = ReachableEnds(*graph, end_of, hurried);
      graph->complete = !ends.empty();
    }
    std::vector<FoundRace> races;
    for (const auto& entry : states_) {
      const Race& race = entry.first;
      const std::vector<uint32_t>& states = entry.second;
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
  std::map<Race, std::vector<uint32_t>> states_;  ///< the states that have the race
  uint32_t next_ = 0;
};

/// A run that ends without ever reaching a state in which a kEventually requirement holds.
std::optional<Failure> WayWithout(const Problem& problem, const StateGraph& graph,
                                  const std::atomic<bool>* hurried) {
  std::optional<Failure> found;
  ForEachFlagged(problem, Scope::kEventually, [&](int requirement, uint32_t flag) {
    if (found) return;
    found = WayTo(graph, kTerminal, flag, hurried);
    if (found) found->fault = {Fault::Kind::kRequirement, requirement, 0};
  });
  return found;
}

/// A run that never ends.
Failure FailureOf(Lasso lasso) {
  Failure failure;
  failure.livelock = true;
  failure.steps = std::move(lasso.stem);
  failure.cycle = std::move(lasso.cycle);
  return failure;
}

/// A run that never gives a response that a kLeads requirement asks for: it ends, or all threads
/// run for ever.
std::optional<Failure> WayUnanswered(const Problem& problem, const StateGraph& graph,
                                     const std::atomic<bool>* hurried) {
  std::optional<Failure> found;
  ForEachFlagged(problem, Scope::kLeads, [&](int requirement, uint32_t flag) {
    if (found) return;
    const StateGraph owing = OweResponses(graph, flag, flag << 1, hurried);
    if (owing.size() == 0) return;
    found = WayTo(owing, kBad, 0, hurried);
    if (!found && graph.complete) {
      Lasso lasso = FindFairCycle(owing, hurried, kOwing);
      if (lasso.found) found = FailureOf(std::move(lasso));
    }
    if (found) found->fault = {Fault::Kind::kRequirement, requirement, 0};
  });
  return found;
}

/// Executes a graph's steps statement by statement.
class StatementPath {
 public:
  explicit StatementPath(const Problem& problem) : problem_(problem), model_(problem.model) {}

  void Take(const std::vector<uint8_t>& steps) {
    for (const uint8_t thread : steps) {
      Begin(thread);
      starts_.push_back(static_cast<int64_t>(taken_.size()));
      model_.Step(thread);
      taken_.push_back(thread);
      TakePrivate(thread);
    }
  }
  /// Executes the private statements at the beginning of all threads that have not executed any
  /// yet.
  void BeginAll() {
    for (int thread = 0; thread < model_.thread_count(); ++thread) Begin(thread);
  }
  bool fault() const { return static_cast<bool>(FindFault(problem_, model_)); }
  /// The statements since the last call.
  std::vector<uint8_t> Taken() { return std::exchange(taken_, {}); }
  /// For each step of the graph, the number of statements before its first one that is not private.
  const std::vector<int64_t>& starts() const { return starts_; }

 private:
  void Begin(int thread) {
    if ((begun_ >> thread & 1) != 0) return;
    begun_ |= 1u << thread;
    TakePrivate(thread);
  }
  void TakePrivate(int thread) {
    const int64_t steps = model_.StepPrivate(thread, kMergedMax);
    taken_.insert(taken_.end(), static_cast<size_t>(steps), static_cast<uint8_t>(thread));
  }

  const Problem& problem_;
  Model model_;
  uint32_t begun_ = 0;
  std::vector<uint8_t> taken_;
  std::vector<int64_t> starts_;
};

/// Converts a failure of a graph of merged statements to statements.
void Unmerge(const Problem& problem, Failure* failure) {
  StatementPath path(problem);
  path.Take(failure->steps);
  if (failure->livelock || !path.fault()) path.BeginAll();
  failure->steps = path.Taken();
  if (failure->last_escape >= 0) {
    const auto escape = static_cast<size_t>(failure->last_escape);
    failure->last_escape = escape < path.starts().size()
                               ? path.starts()[escape]
                               : static_cast<int64_t>(failure->steps.size());
  }
  path.Take(failure->cycle);
  failure->cycle = path.Taken();
  failure->fewest_steps = 0;
  Model model = problem.model;
  failure->preemptions = CountPreemptions(&model, failure->steps);
}

/// The way on which the search found the first bad state; of merged statements, Unmerge() counts
/// the preemptions.
Failure FirstWayToBad(const Problem& problem, const StateSearch& search) {
  Failure failure;
  failure.steps = search.graph.way_to_bad;
  if (search.counts.merged) return failure;
  Model model = problem.model;
  failure.preemptions = CountPreemptions(&model, failure.steps);
  return failure;
}

bool SeesLocals(const Problem& problem) {
  return std::ranges::any_of(problem.requirements, [](const BoundRequirement& requirement) {
    return requirement.scope == Scope::kFinal && requirement.property.SeesLocals();
  });
}

/// True if an exchange of equal threads changes nothing that is asked. Threads whose statements are
/// checked have no equals.
bool CanExchange(const Problem& problem) {
  return problem.races == RaceRule::kAny &&
         std::ranges::all_of(problem.requirements, [](const BoundRequirement& requirement) {
           switch (requirement.scope) {
             case Scope::kFinal:
             case Scope::kAlways:
             case Scope::kNever:
               return requirement.property.SeesGlobalsAlone();
             case Scope::kAssert:
               return true;
             default:
               return false;
           }
         });
}

/// The search of the graph that the limits ask for.
StateSearch SearchGraph(const Problem& problem, const StateLimits& limits) {
  StateSearch search;
  search.counts.merged = limits.merge_private;
  Model model = problem.model;
  const bool dead_locals = limits.merge_private && limits.dead_locals && !SeesLocals(problem);
  if (dead_locals) FindDeadLocals(&model);
  model.TrackKey(true);
  model.NoteIn(&search.coverage);
  const EqualThreads equal = limits.symmetry ? EqualThreads(model) : EqualThreads();
  Model exchanged = model;
  KeySet globals;
  KeySet full;
  RaceSearch races(problem);
  std::vector<uint32_t> final_of;  // for each terminal state, in order, the number of its globals
  std::vector<uint32_t> end_of;    // for each state, the number of its end if it is one
  const bool every = problem.HasInvariants() || problem.races != RaceRule::kAny;
  const Judged judged = every ? Judged::kEveryState : Judged::kEnds;
  const auto judge = [&](const Model& state) {
    const bool bad = static_cast<bool>(FindFault(problem, state));
    uint32_t end = 0;
    if (state.runnable() == 0) {
      bool added = false;
      final_of.push_back(globals.FindOrAdd(state.GlobalsKey(), &added));
      const auto add = [&](const Model& ended) {
        end = full.FindOrAdd(ended.FinalKey(), &added);
        if (added && problem.requirements.empty()) search.ends.Add(EndOf(ended));
      };
      if (equal.empty()) {
        add(state);
      } else {
        ForEachExchange(equal, state, &exchanged, add);
      }
    }
    races.Examine(state);
    if (problem.races != RaceRule::kAny) end_of.push_back(end);
    search.counts.bad_states += bad ? 1 : 0;
    return (bad ? kBad : 0u) | HoldingFlags(problem, state);
  };
  search.graph = BuildStateGraph(&model, limits, judge, judged);
  // What is computed from the states also ends soon when it is told to.
  const std::atomic<bool>* hurried = HurriedOf(limits.progress);
  search.races = races.Finish(end_of, hurried, &search.graph);
  search.counts.states = search.graph.size();
  search.counts.transitions = search.graph.transitions;
  search.counts.final_globals = globals.size();
  search.counts.final_full = full.size();
  search.counts.complete = search.graph.complete;
  search.counts.symmetric = search.graph.symmetric;
  equal.Include(problem.model, &search.coverage);
  // Preemptions are those of single threads.
  if (!search.counts.complete || search.counts.symmetric) return search;

  const std::vector<uint8_t> preemptions =
      PreemptionsTo(search.graph, kPreemptionBounds - 1, hurried);
  if (IsTold(hurried)) return search;
  std::vector<int> fewest(globals.size(), kPreemptionBounds);
  size_t terminal = 0;
  for (uint32_t state = 0; state < search.graph.size(); ++state) {
    if ((search.graph.flags[state] & kTerminal) == 0) continue;
    int& best = fewest[final_of[terminal++]];
    best = std::min(best, int{preemptions[state]});
  }
  for (int bound = 0; bound < kPreemptionBounds; ++bound) {
    search.counts.finals_within.push_back(
        std::count_if(fewest.begin(), fewest.end(), [&](int least) { return least <= bound; }));
  }
  return search;
}

}  // namespace

StateSearch SearchStates(const Problem& problem, const StateLimits& limits) {
  StateLimits whole = limits;
  whole.symmetry = false;
  const bool has_equals = limits.merge_private && limits.symmetry && CanExchange(problem) &&
                          !EqualThreads(problem.model).empty();
  if (!has_equals) return SearchGraph(problem, whole);
  StateLimits first = limits;
  first.states_after_bad = 1;
  first.ends_at_cycle = !problem.may_last;
  StateSearch exchanged = SearchGraph(problem, first);
  const bool bad = exchanged.counts.bad_states > 0;
  if (!bad && !exchanged.graph.found_cycle) return exchanged;
  StateSearch search = SearchGraph(problem, whole);
  if (bad && search.counts.bad_states == 0) {
    search.counts.bad_states = exchanged.counts.bad_states;
    search.graph.way_to_bad = std::move(exchanged.graph.way_to_bad);
  }
  return search;
}

std::optional<Failure> WayTo(const StateGraph& graph, uint32_t flag, uint32_t avoid,
                             const std::atomic<bool>* hurried) {
  Path path = FewestPreemptions(graph, flag, avoid, hurried);
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

std::optional<Failure> FailureIn(const Problem& problem, const StateSearch& search,
                                 const std::atomic<bool>* hurried) {
  const StateGraph& graph = search.graph;
  const auto in_statements = [&](std::optional<Failure> failure) {
    if (failure && search.counts.merged) Unmerge(problem, &*failure);
    return failure;
  };
  const auto walk_to_end = [&](const Failure& failure) {
    Model model = problem.model;
    for (const uint8_t thread : failure.steps) model.Step(thread);
    return model;
  };
  if (search.counts.bad_states > 0) {
    auto way = WayTo(graph, kBad, 0, hurried);
    // In a hurry, or where only the search with equal threads has come to it.
    if (!way) way = FirstWayToBad(problem, search);
    if (auto bad = in_statements(std::move(way))) {
      bad->fault = FindFault(problem, walk_to_end(*bad));
      return bad;
    }
  }
  const auto counted = [&](Failure failure) {
    if (search.counts.merged) {
      Unmerge(problem, &failure);
    } else {
      Model model = problem.model;
      failure.preemptions = CountPreemptions(&model, failure.steps);
    }
    return failure;
  };
  if (auto without = in_statements(WayWithout(problem, graph, hurried))) return without;
  if (auto unanswered = WayUnanswered(problem, graph, hurried)) {
    return unanswered->livelock ? counted(*std::move(unanswered))
                                : in_statements(std::move(unanswered));
  }
  const bool looks_for_cycle = graph.complete && !problem.may_last;
  if (Lasso lasso = looks_for_cycle ? FindFairCycle(graph, hurried) : Lasso{}; lasso.found) {
    return counted(FailureOf(std::move(lasso)));
  }
  if (search.races.empty()) return std::nullopt;
  auto racing = in_statements(WayTo(graph, kRacing, 0, hurried));
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

}  // namespace oncard::explore
