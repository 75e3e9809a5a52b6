// Responses (`leads`, `within`) under all schedules: searches against their definition on random
// programs, whose runs are enumerated one by one.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <map>
#include <random>

#include "compiler/compiler.h"
#include "explore/engines/card_graph.h"
#include "explore/scenario_exploration.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"
#include "runtime/scenario/run/scenario_run.h"
#include "tests/base/random_cases.h"
#include "tests/compiler/memory_files.h"

namespace oncard::explore {
namespace {

using ::testing::HasSubstr;

/// Two threads with a few statements on `a` and `b`; a thread may wait for a value in a loop, or,
/// on a card, for a time.
std::string RandomAnswers(uint64_t seed, bool loops, bool card) {
  std::mt19937_64 random(seed);
  const auto below = [&](uint64_t n) { return static_cast<int>(random() % n); };
  std::string source = "int a, b;\n";
  for (int thread = 0; thread < 2; ++thread) {
    source += fmt::format("int t{}() {{\n  int c;\n", thread);
    const int statements = 2 + below(3);
    for (int i = 0; i < statements; ++i) {
      const char* variable = below(2) == 0 ? "a" : "b";
      switch (below(6)) {
        case 0:
          source += loops ? fmt::format("W{0}:\n  c = {1} == {2};\n  if (c) goto W{0};\n", i,
                                        variable, below(2))
                          : "  a = b;\n";
          break;
        case 1:
        case 2:
          if (card) {
            source += fmt::format("  GT_Delay({});\n", below(2));
            break;
          }
          [[fallthrough]];
        default:
          source += fmt::format("  {} = {};\n", variable, below(3) == 0 ? 0 : 1);
          break;
      }
    }
    source += "  return 0;\n}\n";
  }
  return source;
}

// --- Without a card ------------------------------------------------------------------------------

/// All states of a problem with one `leads`, and what the definition says of them. Nothing here is
/// an algorithm of the explorer: sets of states grow or shrink until nothing changes.
class AllStates {
 public:
  explicit AllStates(const Problem& problem) : problem_(problem), model_(problem.model) {
    model_.TrackKey(true);
    Enter();
  }

  /// A run that is fair, or ends, and gives no response to a state with the left side.
  bool Violated() const {
    const std::vector<bool> silent = Silent([this](size_t s) { return !right_[s]; });
    for (size_t s = 0; s < next_.size(); ++s) {
      if (left_[s] && silent[s]) return true;
    }
    return false;
  }
  /// A fair run that never ends.
  bool Endless() const {
    const std::vector<bool> all(next_.size(), true);
    const std::vector<bool> fair = Fair(all);
    return std::ranges::find(fair, true) != fair.end();
  }

 private:
  using Key = std::pair<uint64_t, uint64_t>;

  size_t Enter() {
    const StateKey key = model_.key();
    const auto [known, added] = numbers_.try_emplace({key.low, key.high}, next_.size());
    const size_t own = known->second;
    if (!added) return own;
    const BoundRequirement& leads = problem_.requirements.front();
    left_.push_back(leads.property.Holds(model_));
    right_.push_back(leads.then->Holds(model_));
    next_.emplace_back(static_cast<size_t>(model_.thread_count()), kNone);
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      if (!model_.Running(thread)) continue;
      model_.Step(thread);
      const size_t next = Enter();
      model_.Undo();
      next_[own][static_cast<size_t>(thread)] = next;
    }
    return own;
  }

  bool Ends(size_t s) const {
    return std::ranges::all_of(next_[s], [](size_t next) { return next == kNone; });
  }

  /// The states from which a path inside a set leads to one of the goals.
  std::vector<bool> Reaching(const std::vector<bool>& inside, std::vector<bool> goals) const {
    for (bool changed = true; changed;) {
      changed = false;
      for (size_t s = 0; s < next_.size(); ++s) {
        if (goals[s] || !inside[s]) continue;
        for (const size_t next : next_[s]) {
          if (next == kNone || !goals[next]) continue;
          goals[s] = changed = true;
        }
      }
    }
    return goals;
  }

  /// The states of a set from which a fair run stays in it for ever (Emerson and Lei).
  std::vector<bool> Fair(const std::vector<bool>& inside) const {
    std::vector<bool> fair = inside;
    for (bool changed = true; changed;) {
      changed = false;
      for (size_t thread = 0; thread < next_[0].size(); ++thread) {
        // States that can go on in the set to a step of the thread, or to where it cannot step.
        std::vector<bool> steps(next_.size(), false);
        for (size_t s = 0; s < next_.size(); ++s) {
          if (!fair[s] || Ends(s)) continue;
          const size_t own = next_[s][thread];
          bool goes_on = false;
          for (const size_t next : next_[s]) goes_on = goes_on || (next != kNone && fair[next]);
          steps[s] = own == kNone ? goes_on : fair[own];
        }
        const std::vector<bool> reaching = Reaching(fair, steps);
        for (size_t s = 0; s < next_.size(); ++s) {
          if (!fair[s] || (reaching[s] && !Ends(s))) continue;
          fair[s] = false;
          changed = true;
        }
      }
    }
    return fair;
  }

  /// The states from which a run stays inside for ever or to its end.
  template <typename Inside>
  std::vector<bool> Silent(Inside is_inside) const {
    std::vector<bool> inside(next_.size());
    for (size_t s = 0; s < next_.size(); ++s) inside[s] = is_inside(s);
    std::vector<bool> goals = Fair(inside);
    for (size_t s = 0; s < next_.size(); ++s) goals[s] = goals[s] || (inside[s] && Ends(s));
    return Reaching(inside, std::move(goals));
  }

  static constexpr size_t kNone = ~size_t{0};

  const Problem& problem_;
  Model model_;
  std::map<Key, size_t> numbers_;
  std::vector<bool> left_;
  std::vector<bool> right_;
  std::vector<std::vector<size_t>> next_;
};

/// Whether the failing run gives no response, by the definition.
bool GivesNone(const Problem& problem, const Failure& failure) {
  const BoundRequirement& leads = problem.requirements.front();
  Model model = problem.model;
  bool owes = false;
  const auto look = [&] {
    owes = (owes || leads.property.Holds(model)) && !leads.then->Holds(model);
  };
  look();
  for (const uint8_t thread : failure.steps) {
    model.Step(thread);
    look();
  }
  if (!failure.livelock) return owes && model.runnable() == 0;
  model.TrackKey(true);
  const StateKey start = model.key();
  uint32_t stepped = 0;
  for (const uint8_t thread : failure.cycle) {
    if (!owes) return false;
    model.Step(thread);
    stepped |= 1u << thread;
    look();
  }
  return owes && model.key() == start && stepped == model.runnable();
}

TEST(ResponseSearch, LeadsIsWhatTheDefinitionSays) {
  int violated = 0;
  int endless = 0;
  const int programs = RandomCases(3000);
  for (int seed = 0; seed < programs; ++seed) {
    const bool loops = seed % 2 != 0;
    const std::string source =
        "//@ leads: a == 1 -> b == 1\n" + RandomAnswers(static_cast<uint64_t>(seed), loops, false);
    const Problem problem = ProblemOf(source);
    const AllStates all(problem);
    const Exploration found =
        Explore(problem, {.engine = EngineKind::kStateful, .merge_private = false}).value();
    if (all.Violated()) {
      ++violated;
      ASSERT_EQ(found.verdict, Verdict::kFailed) << source;
      ASSERT_EQ(found.failure->fault.kind, Fault::Kind::kRequirement) << source;
      ASSERT_TRUE(GivesNone(problem, *found.failure)) << source;
      endless += found.failure->livelock ? 1 : 0;
    } else if (all.Endless()) {
      ASSERT_TRUE(found.failure && found.failure->livelock && !found.failure->fault) << source;
    } else {
      ASSERT_EQ(found.verdict, Verdict::kProved) << source;
    }
    // Globals alone are named, so that private statements can be merged.
    const Exploration merged =
        Explore(problem, {.engine = EngineKind::kStateful, .merge_private = true}).value();
    ASSERT_EQ(merged.verdict, found.verdict) << source;
    if (loops) continue;
    const Exploration bounded =
        Explore(problem, {.engine = EngineKind::kBounded, .preemption_limit = 100}).value();
    ASSERT_EQ(bounded.verdict == Verdict::kFailed, all.Violated()) << source;
    if (found.failure) {
      ASSERT_EQ(bounded.failure->preemptions, found.failure->preemptions) << source;
    }
  }
  EXPECT_GT(violated, programs / 6);
  EXPECT_GT(endless, programs / 150);
}

// The search of traces skips the states in between, though it could execute this program at once.
TEST(ResponseSearch, IsLeftToTheGraphOfStatesHoweverLargeItIs) {
  std::string source = "int a[6];\n//@ leads: a[0] == 1 -> a[0] == 9\n";
  for (int thread = 0; thread < 6; ++thread) {
    source += fmt::format(
        "int t{0}() {{\n  int c;\nL:\n  a[{0}] = a[{0}] + 1;\n"
        "  c = a[{0}] < 9;\n  if (c) goto L;\n  return 0;\n}}\n",
        thread);
  }
  const Exploration found = Explore(ProblemOf(source), {.state_limit = 600'000}).value();
  EXPECT_EQ(found.verdict, Verdict::kIncomplete);
  EXPECT_FALSE(found.traces);
}

TEST(ResponseSearch, AWaitingLoopAnswersOnlyIfItsThreadIsNotStarved) {
  // t1 answers as soon as it sees a; no fair schedule keeps it from that, however long t0 loops.
  const std::string threads =
      "int a, b;\nint t0() {\n  int c;\n  a = 1;\nW:\n  c = b == 0;\n  if (c) goto W;\n  return "
      "0;\n"
      "}\nint t1() {\n  int c;\nW:\n  c = a == 0;\n  if (c) goto W;\n";
  const Findings given =
      FindingsOf("//@ leads: a == 1 -> b == 1\n" + threads + "  b = 1;\n  return 0;\n}\n", {});
  EXPECT_EQ(given.exploration.verdict, Verdict::kProved);
  EXPECT_THAT(TextReport(given, Language::kEnglish, {}),
              HasSubstr("leads: no thread that can run waits for ever for its next statement"));
  // Without the answer both wait for ever: the report has the state since when, and the loop.
  const Findings never =
      FindingsOf("//@ leads: a == 1 -> b == 1\n" + threads + "  goto W;\n}\n", {});
  EXPECT_EQ(never.exploration.verdict, Verdict::kFailed);
  const std::string text = TextReport(never, Language::kEnglish, {});
  EXPECT_THAT(text, HasSubstr("leads: a == 1 -> b == 1 does not hold: 'a == 1' held after step "));
  EXPECT_THAT(text, HasSubstr("and 'b == 1' neither then nor later: b is 0\n"));
  EXPECT_THAT(text, HasSubstr("and then for ever:"));
}

TEST(ResponseSearch, AnEndWithoutTheRightSideIsShown) {
  const Findings found = FindingsOf(
      "int a, b;\n//@ leads: a == 1 -> b == 1\nint t0() {\n  b = 0;\n  a = 1;\n  return 0;\n}\n"
      "int t1() {\n  b = 1;\n  return 0;\n}\n",
      {});
  ASSERT_TRUE(found.exploration.failure);
  EXPECT_THAT(TextReport(found, Language::kEnglish, {}),
              HasSubstr("leads: a == 1 -> b == 1 does not hold: 'a == 1' held after step "));
}

TEST(ResponseSearch, TracesDoNotTellOfLeads) {
  const Problem problem =
      ProblemOf("int a;\n//@ leads: a == 1 -> a == 0\nint t0() {\n  a = 1;\n  a = 0;\n}\n");
  const auto refused = Explore(problem, {.engine = EngineKind::kDpor});
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().message.en, HasSubstr("'leads' concerns intermediate states"));
}

TEST(ResponseSearch, IsUntestedWhereItsLeftSideNeverHeld) {
  const Problem problem =
      ProblemOf("int a;\n//@ leads: a == 2 -> a == 0\nint t0() {\n  a = 1;\n}\n");
  EXPECT_EQ(Explore(problem, {}).value().verdict, Verdict::kProved);
  const auto untested = UntestedOf(problem);
  ASSERT_EQ(untested.size(), 1u);
  EXPECT_THAT(untested[0].en, HasSubstr("'a == 2' never held"));
}

TEST(ResponseSearch, TimeNeedsACard) {
  const std::string source =
      "int a;\n//@ within 5 ms: a == 1 -> a == 0\nint t0() {\n  a = 1;\n  return 0;\n}\n";
  const vm::Object object = *compiler::CompileText("p.c", source, {}, compiler::NoFiles()).object;
  const auto read = ReadComments("p.c", source, object);
  const auto problem = ProblemOfScenario(read.value().scenario, read.value().requirements, object);
  ASSERT_FALSE(problem.ok());
  EXPECT_THAT(
      problem.error().message.en,
      testing::StartsWith("p.c:2:5: no time passes in a program that calls no GT commands"));
}

struct WrongComment {
  const char* comment;
  const char* message;
};

TEST(ResponseSearch, AWrongCommentIsAnErrorAtItsPlace) {
  for (const WrongComment& wrong :
       {WrongComment{"//@ within: a -> a", "p.c:1:5: 'within' needs a time of 0 to 1e9 ms"},
        WrongComment{"//@ within -5 ms: a -> a", "p.c:1:5: 'within -5 ms' needs a time"},
        WrongComment{"//@ within 5: a -> a", "p.c:1:5: 'within 5' needs a time"},
        WrongComment{"//@ within many ms: a -> a", "p.c:1:5: 'within many ms' needs a time"},
        WrongComment{"//@ leads: a", "p.c:1:12: 'a' must be two conditions with '->'"},
        WrongComment{"//@ leads: a -> a -> a", "p.c:1:12: 'a -> a -> a' has more than one '->'"},
        WrongComment{"//@ leads: a -> d", "p.c:1:17: there is no variable 'd'"},
        WrongComment{"//@ leads:", "p.c:1:1: 'leads:' is not a comment"}}) {
    const std::string source = std::string(wrong.comment) + "\nint a;\nint t0() { a = 1; }\n";
    const vm::Object object = *compiler::CompileText("p.c", source, {}, compiler::NoFiles()).object;
    const auto read = ReadComments("p.c", source, object);
    const std::string message =
        read.ok() ? ProblemOfScenario(read.value().scenario, read.value().requirements, object)
                        .error()
                        .message.en
                  : read.error().message.en;
    EXPECT_THAT(message, testing::StartsWith(wrong.message)) << wrong.comment;
  }
}

// --- With a card ---------------------------------------------------------------------------------

/// The states of one run as the run itself shows them.
class StateList : public runtime::RunWatch {
 public:
  struct Seen {
    bool left;
    bool right;
    int64_t ns;
  };

  void Begin(const runtime::Controller& controller, runtime::ScenarioErrors*) override {
    const auto bind = [&](const char* text) {
      return runtime::CardCondition::Bind(runtime::ParseCondition(text).value(), controller)
          .value();
    };
    sides_ = {bind("a == 1"), bind("b == 1")};
  }
  bool ObservesStates() const override { return true; }
  void ObserveState(const runtime::Controller& controller) override {
    states_.push_back({sides_[0].Holds(controller), sides_[1].Holds(controller),
                       controller.clock().NsOf(controller.cycle())});
  }
  void End(const runtime::Controller&) override {}

  /// True if a state is late, by the definition.
  bool Late(int64_t limit_ns) const {
    for (size_t i = 0; i < states_.size(); ++i) {
      if (!states_[i].left) continue;
      bool answered = false;
      bool over = false;
      for (size_t j = i; j < states_.size(); ++j) {
        const bool in_time = states_[j].ns - states_[i].ns <= limit_ns;
        answered = answered || (states_[j].right && in_time);
        over = over || !in_time;
      }
      if (over && !answered) return true;
    }
    return false;
  }
  bool Unanswered() const {
    for (size_t i = 0; i < states_.size(); ++i) {
      if (!states_[i].left) continue;
      bool answered = false;
      for (size_t j = i; j < states_.size(); ++j) answered = answered || states_[j].right;
      if (!answered) return true;
    }
    return false;
  }

 private:
  std::vector<runtime::CardCondition> sides_;
  std::vector<Seen> states_;
};

/// A program with its scenario, and all its schedules.
struct CardProgram {
  vm::Object object;
  runtime::Scenario scenario;
  Subject subject;
  std::vector<std::vector<uint8_t>> schedules;
};

void ListSchedules(CardModel* model, const CardModel::State& state, std::vector<uint8_t>* steps,
                   size_t most, std::vector<std::vector<uint8_t>>* schedules) {
  if (schedules->size() > most) return;
  if (state.ended) {
    schedules->push_back(*steps);
    return;
  }
  for (uint32_t choices = state.choices; choices != 0; choices &= choices - 1) {
    const int thread = std::countr_zero(choices);
    steps->push_back(static_cast<uint8_t>(thread));
    ListSchedules(model, model->Step(state, thread), steps, most, schedules);
    steps->pop_back();
  }
}

CardProgram CardProgramOf(const std::string& source, const std::string& keys, size_t most) {
  CardProgram program;
  program.object = *compiler::CompileText("p.c", source, {}, compiler::NoFiles()).object;
  program.scenario = runtime::ParseScenario("program = \"p.c\"\n" + keys, "t.toml").value();
  program.scenario.threads = ReadComments("p.c", source, program.object).value().scenario.threads;
  CardModel model = CardModel::Create(program.scenario, {}, program.object).value();
  program.subject = SubjectOf(model);
  std::vector<uint8_t> steps;
  ListSchedules(&model, model.Start(), &steps, most, &program.schedules);
  return program;
}

/// Follows a schedule of the program.
void Watch(const CardProgram& program, const std::vector<uint8_t>& steps, StateList* states) {
  Failure failure;
  failure.steps = steps;
  runtime::RunOptions options;
  options.replay = std::make_shared<const vm::Schedule>(ScheduleOf(program.subject, failure));
  options.watch = states;
  EXPECT_TRUE(runtime::RunScenario(program.scenario, program.object, options).ok());
}

TEST(ResponseSearch, ResponsesInTimeAreWhatTheDefinitionSays) {
  constexpr size_t kSchedules = 60;
  // Two statements in a cycle of 0.25 ms.
  const std::string keys = "rate = 8\nuntil_ms = 5\n";
  int programs = 0;
  std::map<bool, int> late;
  std::map<bool, int> unanswered;
  const int seeds = RandomCases(400);
  for (int seed = 0; seed < seeds; ++seed) {
    const std::string source = RandomAnswers(static_cast<uint64_t>(seed), false, true);
    CardProgram program = CardProgramOf(source, keys, kSchedules);
    if (program.schedules.size() > kSchedules) continue;
    ++programs;
    const int64_t us =
        std::vector<int64_t>{0, 200, 250, 499, 500, 1000, 1250}[static_cast<size_t>(seed % 7)];
    bool is_late = false;
    bool is_unanswered = false;
    for (const std::vector<uint8_t>& steps : program.schedules) {
      StateList states;
      Watch(program, steps, &states);
      is_late = is_late || states.Late(us * 1000);
      is_unanswered = is_unanswered || states.Unanswered();
    }
    ++late[is_late];
    ++unanswered[is_unanswered];
    const auto verdict_of = [&](const Requirement& requirement, EngineKind engine) {
      CardModel model = CardModel::Create(program.scenario, {requirement}, program.object).value();
      return ExploreCard(&model, {.engine = engine, .preemption_limit = 100}).verdict;
    };
    const Requirement within = {
        .scope = Scope::kWithin, .text = "a == 1", .then = "b == 1", .within_us = us};
    const Requirement leads = {.scope = Scope::kLeads, .text = "a == 1", .then = "b == 1"};
    for (const EngineKind engine : {EngineKind::kStateful, EngineKind::kBounded}) {
      ASSERT_EQ(verdict_of(within, engine) == Verdict::kFailed, is_late) << us << "\n" << source;
      ASSERT_EQ(verdict_of(leads, engine) == Verdict::kFailed, is_unanswered) << source;
    }
  }
  EXPECT_GT(programs, seeds / 2);
  for (const bool fails : {false, true}) {
    EXPECT_GT(late[fails], seeds * 3 / 40) << fails;
    EXPECT_GT(unanswered[fails], seeds * 3 / 40) << fails;
  }
}

// An input rises at 2 ms and is seen after the filter of three cycles; the poller answers in the
// same cycle, or in the next one if the other thread takes the statements.
constexpr const char* kPoll =
    "int n, answer;\nint t0() {\n  long di;\n  int c;\nW:\n  GT_GetDi(4, &di);\n  c = di & 1;\n"
    "  c = c == 0;\n  if (c) goto W;\n  answer = 1;\n  return 0;\n}\n";

TEST(ResponseSearch, APollingLoopHasFinitelyManyStates) {
  const auto states = [](const std::string& within) {
    CardModel model =
        CardOf(kPoll, "rate = 8\nuntil_ms = 8\n" + within +
                          "[[world.input]]\ntype = \"gpi\"\nindex = 1\nvalue = 1\nat_ms = 2\n");
    const CardGraph graph = BuildCardGraph(&model, {});
    EXPECT_TRUE(graph.graph.complete);
    return std::pair(graph.graph.size(), graph.bad_states);
  };
  const auto plain = states("");
  // What is owed is a function of the clock here, so it adds no state.
  EXPECT_EQ(states("within = [{ after = \"gpi[1] == 1\", then = \"answer == 1\", ms = 4 }]\n"),
            plain);
  EXPECT_EQ(
      states("within = [{ after = \"gpi[1] == 1\", then = \"answer == 1\", ms = 0 }]\n").second, 1);
}

TEST(ResponseSearch, RandomSchedulesAreFollowedToTheirEnds) {
  // t1 takes the answer back if it comes last; on the card each thread waits for 1 ms first.
  const auto source = [](const char* waits) {
    return fmt::format(
        "int a, b;\nint t0() {{\n{0}  a = 1;\n  b = 1;\n  return 0;\n}}\n"
        "int t1() {{\n{0}  b = 0;\n  return 0;\n}}\n",
        waits);
  };
  const Problem fails = ProblemOf("//@ leads: a == 1 -> a == 1 && b == 1\n" + source(""));
  const Problem holds = ProblemOf("//@ leads: b == 1 -> a == 1\n" + source(""));
  const std::string leads = "leads = [\"a == 1 -> b == 1 && a == 0\"]\n";
  const std::string within = "within = [{ after = \"a == 1\", then = \"a == 1\", ms = 0 }]\n";
  for (const EngineKind engine : {EngineKind::kRandom, EngineKind::kPct, EngineKind::kPos}) {
    const ExploreOptions options = {.engine = engine, .runs = 200};
    EXPECT_EQ(Explore(fails, options).value().verdict, Verdict::kFailed) << EngineName(engine);
    EXPECT_EQ(Explore(holds, options).value().verdict, Verdict::kPassed) << EngineName(engine);
    CardModel failing = CardOf(source("  GT_Delay(1);\n"), leads);
    EXPECT_EQ(ExploreCard(&failing, options).verdict, Verdict::kFailed) << EngineName(engine);
    CardModel good = CardOf(source("  GT_Delay(1);\n"), within);
    EXPECT_EQ(ExploreCard(&good, options).verdict, Verdict::kPassed) << EngineName(engine);
  }
}

TEST(ResponseSearch, AReportNamesBothStates) {
  const Findings found =
      FindingsOf("int a, b;\nint t0() {\n  a = 1;\n  GT_Delay(2);\n  b = 1;\n  return 0;\n}\n",
                 "within = [{ after = \"a == 1\", then = \"b == 1\", ms = 1.5 }]\n", {});
  EXPECT_EQ(found.exploration.verdict, Verdict::kFailed);
  EXPECT_THAT(
      TextReport(found, Language::kEnglish, {}),
      HasSubstr("within 1.5 ms: a == 1 -> b == 1 does not hold: 'a == 1' held after step 1, "
                "at 0.25 ms, and 'b == 1' did not within 1.5 ms; too late after step 2, at "
                "2 ms: b is 0\n"));
  EXPECT_THAT(JsonReport(found), HasSubstr("\"expression\": \"a == 1 -> b == 1\""));
}

}  // namespace
}  // namespace oncard::explore
