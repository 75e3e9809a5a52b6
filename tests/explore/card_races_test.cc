// Races with a card (CardRaces in explore/models/races.h): of variables, and of threads that set
// one axis, coordinate system or output.
#include <fmt/core.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/random.h"
#include "explore/reports/failure_report.h"
#include "explore/scenario_exploration.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"
#include "tests/base/random_cases.h"

namespace oncard::explore {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kNoRaces = "races = \"none\"\nrate = 100\n";

/// The two bodies as threads 0 and 1, each in a line of its own, after a line with the globals.
std::string TwoBodies(const std::string& one, const std::string& other) {
  return "int g, f, s, w;\nint t0() { int l; " + one + " }\nint t1() { int l; " + other + " }\n";
}

/// What the report lists.
std::vector<std::string> RacesOf(const Findings& findings) {
  std::vector<std::string> races;
  for (const FoundRace& found : findings.exploration.races) {
    races.push_back(DescribeRace(findings.subject, found.race).en);
  }
  return races;
}

// In some schedules axis 1 ends the run and in others axis 2, and either thread can be the first
// one.
TEST(CardRaces, AreListedEachOnceWithBothPlaces) {
  const Findings findings = FindingsOf(
      "int t0() {\n  GT_SetVel(1, 5);\n  GT_SetVel(2, 5);\n  return 0;\n}\n"
      "int t1() {\n  GT_Stop(2, 0);\n  GT_Stop(1, 0);\n  return 0;\n}\n",
      kNoRaces, {.all = true});
  EXPECT_THAT(RacesOf(findings),
              ElementsAre("threads 0 and 1 both command axis 1: GT_SetVel in line 2, GT_Stop in "
                          "line 8; nothing orders them",
                          "threads 0 and 1 both command axis 2: GT_SetVel in line 3, GT_Stop in "
                          "line 7; nothing orders them"));
  const auto json = nlohmann::json::parse(JsonReport(findings));
  ASSERT_EQ(json["races"].size(), 2u);
  EXPECT_EQ(json["races"][0]["what"], "axis 1");
  EXPECT_EQ(json["races"][0]["statements"][1]["line"], 8);
  EXPECT_THAT(TextReport(findings, Language::kEnglish),
              HasSubstr("\nthreads 0 and 1 both command axis 2: GT_SetVel in line 3, GT_Stop in "
                        "line 7; nothing orders them\n"));
}

struct OwnerCase {
  const char* name;
  const char* one;
  const char* other;
  /// What both set, as the reason says; nullptr: there is no race.
  const char* what;
};

class OwnersTest : public ::testing::TestWithParam<OwnerCase> {};

TEST_P(OwnersTest, AreOneAtATime) {
  const OwnerCase& tried = GetParam();
  const Findings findings =
      FindingsOf(TwoBodies(tried.one, tried.other), std::string(kNoRaces) + "sync = [\"f\"]\n", {});
  const auto& failure = findings.exploration.failure;
  if (tried.what == nullptr) {
    EXPECT_EQ(findings.exploration.verdict, Verdict::kProved);
    return;
  }
  ASSERT_EQ(findings.exploration.verdict, Verdict::kFailed);
  ASSERT_EQ(failure->fault.kind, Fault::Kind::kRace);
  EXPECT_EQ(DescribeRace(findings.subject, failure->fault.race).en, tried.what);
}

INSTANTIATE_TEST_SUITE_P(
    Card, OwnersTest,
    ::testing::Values(
        OwnerCase{"Axis", "GT_SetVel(2, 5);", "GT_Stop(2, 0);",
                  "threads 0 and 1 both command axis 2: GT_SetVel in line 2, GT_Stop in line 3; "
                  "nothing orders them"},
        OwnerCase{"OtherAxis", "GT_SetVel(2, 5);", "GT_Stop(1, 0);", nullptr},
        OwnerCase{"ReadingIsNone", "GT_SetVel(2, 5);", "double v; GT_GetVel(2, &v);", nullptr},
        OwnerCase{"TimeAloneOrdersNothing", "GT_SetVel(2, 5);", "GT_Delay(9); GT_Stop(2, 0);",
                  "threads 0 and 1 both command axis 2: GT_SetVel in line 2, GT_Stop in line 3; "
                  "nothing orders them"},
        OwnerCase{"AFlagOrders", "GT_SetVel(2, 5); f = 1;",
                  "l = f; if (l) goto D; return 0; D: GT_Stop(2, 0); return 1;", nullptr},
        OwnerCase{"WhatFollowsTheFlagIsNotOrdered", "f = 1; GT_SetVel(2, 5);",
                  "l = f; if (l) goto D; return 0; D: GT_Stop(2, 0); return 1;",
                  "threads 0 and 1 both command axis 2: GT_SetVel in line 2, GT_Stop in line 3; "
                  "nothing orders them"},
        OwnerCase{"AWaitOrders", "GT_SetVel(2, 5); w = 1;",
                  "GT_WaitForVarEq(&w, 1); GT_Stop(2, 0);", nullptr},
        OwnerCase{"ServosOfTwoAxes", "GT_AxisOn(1);", "GT_AxisOff(2);", nullptr},
        OwnerCase{"ServoOfOneAxis", "GT_AlarmOff(1); GT_AxisOn(1);", "GT_AxisOff(1);",
                  "threads 0 and 1 both command axis 1: GT_AlarmOff in line 2, GT_AxisOff in line "
                  "3; nothing orders them"},
        OwnerCase{"BitsSetSingly", "GT_SetDoBit(12, 3, 1);", "GT_SetDoBit(12, 4, 1);", nullptr},
        OwnerCase{
            "OneBit", "GT_SetDoBit(12, 3, 1);", "GT_SetDoBit(12, 3, 0);",
            "threads 0 and 1 both set output 3 of word 12: GT_SetDoBit in line 2, GT_SetDoBit "
            "in line 3; nothing orders them"},
        OwnerCase{"ABitOfAWord", "GT_SetDoBit(12, 16, 1);", "GT_SetDo(12, 0);",
                  "threads 0 and 1 both set output 16 of word 12: GT_SetDoBit in line 2, GT_SetDo "
                  "in line 3; nothing orders them"},
        OwnerCase{"TheEnableOutputOfAnAxis", "GT_AxisOn(2);", "GT_SetDoBit(10, 2, 1);",
                  "threads 0 and 1 both set output 2 of word 10: GT_AxisOn in line 2, GT_SetDoBit "
                  "in line 3; nothing orders them"},
        OwnerCase{"CoordinateSystem", "GT_SetOverride(1, 0.5);", "GT_CrdStart(1, 0);",
                  "threads 0 and 1 both command coordinate system 1: GT_SetOverride in line 2, "
                  "GT_CrdStart in line 3; nothing orders them"},
        OwnerCase{"OtherCoordinateSystem", "GT_SetOverride(1, 0.5);", "GT_CrdStart(2, 0);",
                  nullptr},
        OwnerCase{"AnalogueOutputs", "GT_SetDac(2, &s, 1);", "GT_SetMtrBias(3, 5);", nullptr},
        OwnerCase{"OneAnalogueOutput", "GT_SetMtrLmt(2, 9);", "GT_SetMtrBias(2, 5);",
                  "threads 0 and 1 both set analogue output 2: GT_SetMtrLmt in line 2, "
                  "GT_SetMtrBias in line 3; nothing orders them"},
        OwnerCase{"OutputsOfAModule", "GT_SetExtIoBit(1, 0, 1); GT_SetExtDaValue(1, 0, 9);",
                  "GT_SetExtIoBit(1, 1, 1); GT_SetExtDaValue(1, 1, 9);", nullptr},
        OwnerCase{"OneOutputOfAModule", "GT_SetExtIoBit(1, 0, 1);", "GT_SetExtIoValue(1, 3);",
                  "threads 0 and 1 both set output 0 of extension module 1: GT_SetExtIoBit in line "
                  "2, GT_SetExtIoValue in line 3; nothing orders them"},
        OwnerCase{"Variables", "GT_Delay(1); g = 1;", "l = g;",
                  "data race: thread 1 reads g in line 3, thread 0 writes it in line 2, and "
                  "nothing orders the two"}),
    [](const auto& test) { return std::string(test.param.name); });

constexpr const char* kTwoOwners =
    "int t0() {\n GT_SetVel(1, 5);\n}\nint t1() {\n GT_Delay(2);\n GT_SetVel(1, 6);\n}\n";

TEST(CardRacesTest, EveryEngineFindsThem) {
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kStateful, EngineKind::kBounded,
                                  EngineKind::kRandom, EngineKind::kPct, EngineKind::kPos}) {
    const Findings findings = FindingsOf(kTwoOwners, kNoRaces, {.engine = engine, .runs = 20});
    ASSERT_EQ(findings.exploration.verdict, Verdict::kFailed) << EngineName(engine);
    EXPECT_EQ(findings.exploration.failure->fault.kind, Fault::Kind::kRace) << EngineName(engine);
  }
}

TEST(CardRacesTest, TheReportSaysWhatWasChecked) {
  const Findings findings = FindingsOf("int f;\nint t0() {\n GT_SetVel(1, 5);\n f = 1;\n}\n",
                                       std::string(kNoRaces) + "sync = [\"f\"]\n", {});
  const std::string text = TextReport(findings, Language::kEnglish);
  EXPECT_THAT(text, HasSubstr("axes, coordinate systems and outputs have one owner at a time\n"
                              "           no data race; synchronising: f; variables for which "
                              "statements wait synchronise, too\n"));
  EXPECT_THAT(TextReport(findings, Language::kChinese),
              HasSubstr("每个轴、坐标系和输出在同一时间只有一个归属线程"));
}

TEST(CardRacesTest, WithoutTheWishNoneIsLookedFor) {
  EXPECT_EQ(FindingsOf(kTwoOwners, "rate = 100\n", {}).exploration.verdict, Verdict::kProved);
}

/// The error for races of that kind.
std::string Refused(const std::string& races) {
  const std::string keys = "races = \"" + races + "\"\n";
  auto findings = TryFindingsOf(kTwoOwners, keys, {});
  return findings.ok() ? "" : findings.error().message.en;
}

TEST(CardRacesTest, WhetherOneIsBenignIsNotKnown) {
  EXPECT_THAT(Refused("benign"), HasSubstr("known only in programs without GT commands"));
  EXPECT_EQ(Refused("none"), "");
}

TEST(CardRacesTest, AFollowedScheduleHasThem) {
  const Findings findings = FindingsOf(kTwoOwners, kNoRaces, {});
  CardModel model = CardOf(kTwoOwners, kNoRaces);
  CardModel::State state = model.Begin();
  for (const uint8_t thread : findings.exploration.failure->steps) model.Advance(&state, thread);
  EXPECT_EQ(state.fault.kind, Fault::Kind::kRace);
  EXPECT_EQ(state.fault.race.first, (RacingStatement{0, 0, true, "GT_SetVel"}));
  EXPECT_EQ(state.fault.race.second, (RacingStatement{1, 1, true, "GT_SetVel"}));
}

// --- Random programs -----------------------------------------------------------------------------

/// What a statement does, as its generator knows it: not by the catalogue.
struct Deed {
  std::set<std::string> reads = {};
  std::set<std::string> sets = {};
  std::string acquires = {};
  std::string releases = {};
  bool waits = false;  ///< acquires again before the thread's next statement
};

struct RandomCardProgram {
  std::string source = "int g, f, w;\n";
  std::map<int, Deed> deeds;  ///< by line
  bool waits = false;
  int lines = 1;

  void Add(const std::string& line, const Deed& deed = {}) {
    source += line + '\n';
    deeds[++lines] = deed;
  }
  void AddRandom(uint64_t* random) {
    const auto axis = static_cast<int>(1 + RandomBelow(*random, 2));
    const std::string name = fmt::format("axis {}", axis);
    switch (RandomBelow(*random, 12)) {
      case 0:
        return Add(fmt::format(" GT_SetVel({}, 5);", axis), {.sets = {name}});
      case 1:
        return Add(fmt::format(" GT_Stop({}, 0);", axis), {.sets = {name}});
      case 2:
        return Add(" GT_Update(3);", {.sets = {"axis 1", "axis 2"}});
      case 3:
        return Add(fmt::format(" GT_SetDoBit(12, {}, 1);", axis),
                   {.sets = {fmt::format("do {}", axis)}});
      case 4:
        return Add(" GT_SetDo(12, 3);", {.sets = {"do 1", "do 2"}});
      case 5:
        return Add(" GT_GetVel(1, &v);", {});
      case 6:
        return Add(" g = 1;", {.sets = {"g"}});
      case 7:
        return Add(" l = g;", {.reads = {"g"}});
      case 8:
        return Add(" f = 1;", {.releases = "f"});
      case 9:
        Add(" l = f;", {.acquires = "f"});
        return Add(" if (l) goto E;");
      case 10:
        if (RandomBelow(*random, 4) != 0) return Add(" w = 1;", {.releases = "w"});
        waits = true;
        return Add(" GT_WaitForVarEq(&w, 1);", {.acquires = "w", .waits = true});
      default:
        return Add(" GT_Delay(1);");
    }
  }
};

RandomCardProgram RandomCard(uint64_t* random) {
  RandomCardProgram program;
  const uint64_t threads = RandomBelow(*random, 10) == 0 ? 3 : 2;
  for (uint64_t thread = 0; thread < threads; ++thread) {
    program.Add(fmt::format("int t{}() {{ int l; double v;", thread));
    const uint64_t statements = threads == 3 ? 1 : 1 + RandomBelow(*random, 3);
    for (uint64_t i = 0; i < statements; ++i) program.AddRandom(random);
    program.Add("E:");
    program.Add(" return 0;");
    program.Add("}");
  }
  // A variable for which nothing waits is one like others.
  for (auto& [line, deed] : program.deeds) {
    if (!program.waits && deed.releases == "w") deed = {.sets = {"w"}};
  }
  return program;
}

/// True if two statements of a run access one thing, one of them sets it, and no chain of
/// statements of one thread, and of writes and reads of a flag, leads from the first to the second.
bool HasRace(const std::vector<std::pair<int, Deed>>& run) {
  std::vector<std::vector<bool>> before(run.size(), std::vector<bool>(run.size()));
  for (size_t later = 0; later < run.size(); ++later) {
    const auto& [thread, deed] = run[later];
    for (size_t earlier = later; earlier-- > 0;) {
      const auto& [other, done] = run[earlier];
      const bool tells = !done.releases.empty() && done.releases == deed.acquires;
      if (other != thread && !tells) continue;
      before[earlier][later] = true;
      for (size_t i = 0; i < earlier; ++i) {
        if (before[i][earlier]) before[i][later] = true;
      }
    }
    for (size_t earlier = 0; earlier < later; ++earlier) {
      if (before[earlier][later]) continue;
      const Deed& done = run[earlier].second;
      const auto meets = [](const std::set<std::string>& one, const std::set<std::string>& all) {
        return std::ranges::any_of(one, [&](const auto& name) { return all.contains(name); });
      };
      if (meets(done.sets, deed.sets) || meets(done.sets, deed.reads) ||
          meets(done.reads, deed.sets)) {
        return true;
      }
    }
  }
  return false;
}

/// Tries every run of a program, without a search for races and without merging states.
bool SomeRunHasRace(const RandomCardProgram& program, CardModel* model) {
  std::vector<uint8_t> prefix;
  for (;;) {
    CardModel::State state = model->Begin();
    std::vector<std::pair<int, Deed>> run;
    std::vector<uint8_t> taken;
    std::vector<uint32_t> choices;
    std::map<int, std::string> awaited;
    while (!state.ended) {
      const size_t step = taken.size();
      const int thread = step < prefix.size() ? prefix[step] : std::countr_zero(state.choices);
      const auto deed = program.deeds.find(model->controller().machine().Line(thread));
      Deed done = deed == program.deeds.end() ? Deed{} : deed->second;
      if (auto wait = awaited.extract(thread)) run.push_back({thread, {.acquires = wait.mapped()}});
      if (done.waits) awaited[thread] = done.acquires;
      run.push_back({thread, std::move(done)});
      choices.push_back(state.choices);
      taken.push_back(static_cast<uint8_t>(thread));
      model->Advance(&state, thread);
    }
    if (HasRace(run)) return true;
    // The next run in order.
    prefix = taken;
    while (!prefix.empty()) {
      const uint32_t untried = choices[prefix.size() - 1] & ~((uint32_t{2} << prefix.back()) - 1);
      if (untried != 0) {
        prefix.back() = static_cast<uint8_t>(std::countr_zero(untried));
        break;
      }
      prefix.pop_back();
    }
    if (prefix.empty()) return false;
  }
}

class RandomCardRacesTest : public ::testing::TestWithParam<int> {};

TEST_P(RandomCardRacesTest, AreThoseOfTheDefinition) {
  uint64_t random = 1000 + static_cast<uint64_t>(GetParam());
  int with = 0;
  int without = 0;
  const int programs = RandomCases(300);
  for (int i = 0; i < programs; ++i) {
    const RandomCardProgram program = RandomCard(&random);
    const std::string rate = i % 5 == 0 ? "rate = 8\n" : "rate = 100\n";
    CardModel plain = CardOf(program.source, rate);
    const bool races = SomeRunHasRace(program, &plain);
    ++(races ? with : without);
    const std::string keys = "races = \"none\"\nsync = [\"f\"]\n" + rate;
    CardModel model = CardOf(program.source, keys);
    const auto explored = [&](EngineKind engine) {
      const Exploration exploration = ExploreCard(&model, {.engine = engine, .runs = 20});
      const auto& failure = exploration.failure;
      return std::pair(exploration.verdict == Verdict::kFailed,
                       failure && failure->fault.kind == Fault::Kind::kRace);
    };
    const auto [fails, by_race] = explored(EngineKind::kStateful);
    // A deadlock can be the failure that is shown.
    ASSERT_EQ(program.waits && fails && !by_race ? races : by_race, races) << program.source;
    ASSERT_TRUE(fails || !races) << program.source;
    if (i % 5 != 0) continue;
    const auto [auto_fails, auto_race] = explored(EngineKind::kAuto);
    ASSERT_EQ(auto_fails, fails) << program.source;
    if (!races) {
      ASSERT_FALSE(auto_race) << program.source;
      ASSERT_FALSE(explored(EngineKind::kPos).second) << program.source;
    }
  }
  EXPECT_GT(with, LeastOfCases(60));
  EXPECT_GT(without, LeastOfCases(60));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCardRacesTest, ::testing::Range(0, 4));

}  // namespace
}  // namespace oncard::explore
