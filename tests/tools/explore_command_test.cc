// explore: verdicts, exit codes, refusals, schedules that can be replayed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

using Json = nlohmann::json;

/// Two threads that add 1 each: with `g = g + 1` in two statements an update can be lost.
constexpr const char* kLostUpdate = R"(int g;
//@ final: g == 2
int t0()
{
  int r;
  r = g;
  g = r + 1;
  return 0;
}
int t1()
{
  int r;
  r = g;
  g = r + 1;
  return 0;
}
)";

const std::string kEstop = ONCARD_SOURCE_DIR "/samples/28_estop";

/// Hashes and versions change with every program and release.
std::string Masked(std::string text) {
  text = std::regex_replace(text, std::regex("[0-9a-f]{16}"), "HASH");
  return std::regex_replace(text, std::regex("oncard [0-9][0-9.]*"), "oncard VERSION");
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(Explore, ShowsTheScheduleThatFails) {
  const ScratchFolder scratch;
  const ProcessResult result =
      RunOncard({"explore", "--engine=stateful", scratch.Write("p.c", kLostUpdate)});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "");
  ExpectGolden("explore_lost_update.txt", Masked(result.out));
}

TEST(Explore, ProvesWithEveryEngine) {
  const ScratchFolder scratch;
  const std::string file =
      scratch.Write("p.c", Replaced(kLostUpdate, "g == 2", "g == 1 || g == 2"));
  for (const char* engine : {"auto", "dpor", "stateful"}) {
    const ProcessResult result =
        RunOncard({"explore", file, std::string("--engine=") + engine, "--format=json"});
    EXPECT_EQ(result.exit_code, 0) << engine;
    EXPECT_EQ(Json::parse(result.out)["verdict"], "PROVED") << engine;
  }
}

TEST(Explore, ALimitIsNoVerdict) {
  const ScratchFolder scratch;
  const std::string file = scratch.Write("p.c", Replaced(kLostUpdate, "g == 2", "g < 3"));
  EXPECT_EQ(RunOncard({"explore", "--engine=stateful", "--max-states=3", file}).exit_code, 6);
  EXPECT_EQ(RunOncard({"explore", "--engine=dpor", "--max-executions=1", file}).exit_code, 6);
}

// Two threads that count to a hundred in three statements have more interleavings than there are
// atoms; a schedule without any preemption shows that additions are lost.
TEST(Explore, AFaultThatNeedsNoPreemptionIsFoundAtOnce) {
  const ProcessResult result =
      RunOncard({"explore", ONCARD_SOURCE_DIR "/samples/07_shared_global/taking_turns.toml",
                 "--format=json"});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["preemptions"], 0);
  EXPECT_EQ(json["min_preemptions_to_bad"], 0);
}

/// A search of many seconds.
std::string LongSearch() {
  std::string large = "int x;\n//@ final: x >= 0\n";
  for (int thread = 0; thread < 8; ++thread) {
    large += "int t" + std::to_string(thread) + "()\n{\n  int t;\n";
    for (int i = 0; i < 50; ++i) large += "  t = x;\n  x = t + 1;\n";
    large += "}\n";
  }
  return large;
}

TEST(Explore, ASearchEndsWhenItsMemoryIsFull) {
  const ScratchFolder scratch;
  scratch.Write("large.c", LongSearch());
  // --all changes nothing: the engine that is chosen without an option.
  for (const char* option : {"--all", "--engine=dpor", "--engine=stateful", "--engine=bounded"}) {
    const ProcessResult full =
        RunOncard({"explore", "large.c", option, "--memory=1"}, scratch.path());
    EXPECT_EQ(full.exit_code, 6) << full.err;
    EXPECT_THAT(full.out, StartsWith("INCOMPLETE\nthe memory limit was reached\n")) << option;
  }
  EXPECT_EQ(RunOncard({"explore", "large.c", "--memory=0"}, scratch.path()).exit_code, 2);
}

TEST(Explore, ASearchEndsWhenItsTimeIsOver) {
  const ScratchFolder scratch;
  scratch.Write("p.c", Replaced(kLostUpdate, "g == 2", "g < 3"));
  const ProcessResult in_time = RunOncard({"explore", "p.c", "--time=600"}, scratch.path());
  EXPECT_EQ(in_time.exit_code, 0) << in_time.err;
  scratch.Write("large.c", LongSearch());
  const ProcessResult late = RunOncard({"explore", "large.c", "--time=0.2"}, scratch.path());
  EXPECT_EQ(late.exit_code, 6) << late.err;
  EXPECT_THAT(late.out, StartsWith("INCOMPLETE\nthe time limit was reached\n"));
  EXPECT_THAT(late.err, HasSubstr("to continue: oncard explore large.search"));
  // An existing search is not overwritten by the next one.
  const std::string kept = scratch.Read("large.search");
  const ProcessResult again = RunOncard({"explore", "large.c", "--time=0.2"}, scratch.path());
  EXPECT_THAT(again.err, HasSubstr("to continue: oncard explore large.2.search"));
  EXPECT_EQ(scratch.Read("large.search"), kept);
  EXPECT_EQ(RunOncard({"explore", "p.c", "--time=0"}, scratch.path()).exit_code, 2);
}

TEST(Explore, TheSavedScheduleReplays) {
  const ScratchFolder scratch;
  const std::string saved = scratch.path() + "/lost.schedule";
  RunOncard({"explore", scratch.Write("p.c", kLostUpdate), "--save", saved});
  const ProcessResult replay = RunOncard({"replay", saved, "--format=json"});
  // The requirements in comments of the source are checked again.
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_EQ(replay.err, "oncard: final: g == 2: does not hold at the end: g is 1\n");
  EXPECT_EQ(Json::parse(replay.out)["values"]["g"], 1);
}

TEST(Explore, ASavedScheduleThatFailsOnTheWayEndsThere) {
  const ScratchFolder scratch;
  scratch.Write("p.c", "//@ always: x < 2\nint x;\nvoid t0() {\n  x = 1;\n  x = 2;\n  x = 3;\n}\n");
  RunOncard({"explore", "p.c", "--save", "p.schedule"}, scratch.path());
  const ProcessResult replay = RunOncard({"replay", "p.schedule"}, scratch.path());
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_EQ(replay.out, "thread 0 t0: running at p.c:6\nx = 2\n");
  EXPECT_THAT(replay.err, StartsWith("oncard: always: x < 2: does not hold after"));
  EXPECT_THAT(replay.err, Not(HasSubstr("the schedule ends after")));
}

struct UnusedSetting {
  const char* engine;
  const char* option;
};

class ExploreSetting : public testing::TestWithParam<UnusedSetting> {};

TEST_P(ExploreSetting, ThatTheEngineCannotUseIsRefused) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kLostUpdate);
  const auto [engine, option] = GetParam();
  const ProcessResult refused =
      RunOncard({"explore", "p.c", std::string("--engine=") + engine, option}, scratch.path());
  EXPECT_EQ(refused.exit_code, 2);
  const std::string text(option);
  const std::string expected = "oncard: '" + text.substr(0, text.find('=')) +
                               "' has no effect with the engine " + engine + ": remove it, or use ";
  EXPECT_THAT(refused.err, StartsWith(expected));
}

INSTANTIATE_TEST_SUITE_P(
    Explore, ExploreSetting,
    testing::Values(UnusedSetting{"stateful", "--max-executions=5"},
                    UnusedSetting{"bounded", "--max-executions=5"},
                    UnusedSetting{"pct", "--max-executions=5"},
                    UnusedSetting{"dpor", "--max-states=5"}, UnusedSetting{"pos", "--max-states=5"},
                    UnusedSetting{"auto", "--runs=5"}, UnusedSetting{"bounded", "--runs=5"},
                    UnusedSetting{"stateful", "--seed=5"}, UnusedSetting{"random", "--depth=5"},
                    UnusedSetting{"auto", "--depth=5"}, UnusedSetting{"dpor", "--preemptions=5"},
                    UnusedSetting{"dpor", "--merge-private"},
                    UnusedSetting{"bounded", "--no-merge-private"},
                    UnusedSetting{"stateful", "--no-islands"}));

TEST(Explore, StatementsAreMergedOrNot) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kLostUpdate);
  const ProcessResult refused =
      RunOncard({"explore", "p.c", "--merge-private", "--no-merge-private"}, scratch.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("contradict each other: give one\n"));
  for (const bool merge : {false, true}) {
    const std::string option = merge ? "--merge-private" : "--no-merge-private";
    const ProcessResult found =
        RunOncard({"explore", "p.c", "--engine=stateful", option}, scratch.path());
    EXPECT_EQ(found.out.find(" merged states, ") != std::string::npos, merge) << found.out;
  }
}

TEST(Explore, ASearchFileHasAnEngineToo) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kLostUpdate);
  const ProcessResult refused =
      RunOncard({"explore", "p.c", "--search=p.search", "--max-states=5"}, scratch.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("'--max-states' has no effect with the engine dpor"));
}

TEST(Explore, TheSavedScheduleFollowsAnEditedProgram) {
  const ScratchFolder scratch;
  const std::string saved = scratch.path() + "/lost.schedule";
  RunOncard({"explore", scratch.Write("p.c", kLostUpdate), "--save", saved});
  scratch.Write("p.c", Replaced(kLostUpdate, "  g = r + 1;", "  r = r + 0;\n  g = r + 1;"));
  const ProcessResult strict = RunOncard({"replay", saved});
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_THAT(strict.err, HasSubstr("recorded with another program"));
  const ProcessResult tolerant = RunOncard({"replay", "--tolerant", saved, "--format=json"});
  EXPECT_EQ(tolerant.exit_code, 1);
  EXPECT_EQ(tolerant.err,
            "followed 3 of 3 segments of the schedule\n"
            "oncard: final: g == 2: does not hold at the end: g is 1\n");
  EXPECT_EQ(Json::parse(tolerant.out)["values"]["g"], 1);
}

TEST(Explore, WritesReports) {
  const ScratchFolder scratch;
  const std::string file = scratch.Write("p.c", kLostUpdate);
  RunOncard({"explore", file, "--report", scratch.path() + "/r.html"});
  EXPECT_THAT(scratch.Read("r.html"), HasSubstr("<p class=\"verdict FAILED\">"));
  RunOncard({"explore", file, "--report", scratch.path() + "/r.json"});
  EXPECT_EQ(Json::parse(scratch.Read("r.json"))["traceEvents"][0]["ph"], "M");
  EXPECT_EQ(RunOncard({"explore", file, "--report", scratch.path() + "/r.txt"}).exit_code, 2);
}

/// The text of a page's block that begins so.
std::string BlockOf(const std::string& page, const std::string& begin) {
  const size_t at = page.find("<pre>" + begin) + 5;
  std::string text = page.substr(at, page.find("</pre>", at) - at);
  for (const auto& [from, to] : {std::pair{"&quot;", "\""}, {"&lt;", "<"}, {"&gt;", ">"}}) {
    text = std::regex_replace(text, std::regex(from), to);
  }
  return text;
}

TEST(Explore, APageSaysHowToRepeatIt) {
  const ScratchFolder scratch;
  const std::string file = scratch.Write("p.c", kLostUpdate);
  RunOncard({"explore", "--engine=stateful", "--max-states=1000", file, "--report",
             scratch.path() + "/r.html"});
  const std::string page = scratch.Read("r.html");
  EXPECT_EQ(BlockOf(page, "oncard explore"),
            "oncard explore p.c --engine=stateful --max-states=1000");
  EXPECT_EQ(BlockOf(page, "oncard replay"), "oncard replay p.schedule");
  scratch.Write("p.schedule", BlockOf(page, "oncard-schedule"));
  const ProcessResult replayed = RunOncard({"replay", scratch.path() + "/p.schedule"});
  EXPECT_EQ(replayed.exit_code, 1);
  EXPECT_THAT(replayed.out + replayed.err, HasSubstr("g is 1"));
}

TEST(Explore, TriesRandomSchedules) {
  const ScratchFolder scratch;
  const std::string file = scratch.Write("p.c", kLostUpdate);
  for (const char* engine : {"random", "pct", "pos"}) {
    const auto explore = [&](const char* runs, const char* seed) {
      return RunOncard({"explore", file, std::string("--engine=") + engine, "--runs", runs,
                        "--seed", seed, "--format=json"});
    };
    const ProcessResult found = explore("1000", "4");
    EXPECT_EQ(found.exit_code, 1) << engine;
    EXPECT_EQ(Json::parse(found.out)["runs"], 1000);
    EXPECT_EQ(found.out, explore("1000", "4").out);
  }
  const std::string right = scratch.Write("right.c", Replaced(kLostUpdate, "g == 2", "g >= 1"));
  const ProcessResult passed = RunOncard({"explore", right, "--engine=random", "--runs=50"});
  EXPECT_EQ(passed.exit_code, 5);
  EXPECT_THAT(passed.out, HasSubstr("PASSED\nnone of 50 random schedules"));
}

TEST(Explore, TakesScenarios) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kLostUpdate);
  const std::string threads =
      "[[thread]]\nthread = 0\nfunction = \"t0\"\n[[thread]]\nthread = 1\n"
      "function = \"t1\"\n";
  const auto explore = [&](const std::string& head, const std::string& tail = {}) {
    return RunOncard({"explore", scratch.Write("s.toml", head + threads + tail)});
  };
  EXPECT_EQ(explore("program = \"p.c\"\nexpect = [\"g == 2\"]\n").exit_code, 1);
  EXPECT_EQ(explore("program = \"p.c\"\nexpect = [\"g >= 1\"]\n").exit_code, 0);
  // Time and the card are included if the scenario requires it.
  EXPECT_EQ(explore("program = \"p.c\"\nexpect = [\"g == 2 @ 5ms\"]\n").exit_code, 1);
  EXPECT_EQ(explore("program = \"p.c\"\nexpect = [\"g >= 1 @ 5ms\"]\n").exit_code, 0);
  EXPECT_EQ(explore("program = \"p.c\"\nuntil_ms = 3\nalways = [\"g < 50\"]\n", "period_ms = 1\n")
                .exit_code,
            5);
  const ProcessResult late =
      explore("program = \"p.c\"\nuntil_ms = 3\nexpect = [\"g >= 1 @ 5ms\"]\n");
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_THAT(late.err, HasSubstr("later than the end of the run"));
  EXPECT_EQ(explore("program = \"p.c\"\nnever = [\"g == 2 && ret0 == 1\"]\n").exit_code, 0);
}

// A failing schedule becomes a scenario for 'oncard test', which fails until the fault is fixed.
TEST(Explore, AFailureBecomesARegressionScenario) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kLostUpdate);
  const auto run = [&](std::vector<std::string> arguments) {
    return RunOncard(arguments, scratch.path());
  };
  EXPECT_EQ(run({"explore", "p.c", "--regression", "lost.toml"}).exit_code, 1);
  EXPECT_TRUE(scratch.Has("lost.schedule"));
  EXPECT_EQ(run({"test", "lost.toml"}).exit_code, 1);
  EXPECT_EQ(run({"explore", "lost.toml"}).exit_code, 1);
  // Changed lines before the fault have no effect.
  scratch.Write("p.c", std::string("int other;\n") + kLostUpdate);
  EXPECT_EQ(run({"test", "lost.toml"}).exit_code, 1);
  std::string corrected = kLostUpdate;
  for (size_t at = corrected.find("g = r + 1;"); at != std::string::npos;
       at = corrected.find("g = r + 1;")) {
    corrected.replace(at, 10, "g = g + 1;");
  }
  scratch.Write("p.c", corrected);
  const ProcessResult test = run({"test", "lost.toml"});
  EXPECT_EQ(test.exit_code, 0) << test.out;
  EXPECT_EQ(run({"explore", "lost.toml"}).exit_code, 5);
  EXPECT_EQ(run({"explore", "p.c", "--regression", "lost.txt"}).exit_code, 2);
}

// A schedule cannot show that something continues forever.
TEST(Explore, ALivelockIsNoRegressionScenario) {
  const ScratchFolder scratch;
  scratch.Write(
      "p.c",
      "int a, b;\nint t0() {\n  int w;\nL:\n  w = a == 0;\n  if (w) goto L;\n  b = 1;\n}\n"
      "int t1() {\n  int w;\nL:\n  w = b == 0;\n  if (w) goto L;\n  a = 1;\n}\n");
  const ProcessResult result =
      RunOncard({"explore", "p.c", "--regression", "live.toml"}, scratch.path());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("livelock"));
  EXPECT_FALSE(scratch.Has("live.toml"));
}

TEST(Explore, RefusesHostEvents) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kLostUpdate);
  const ProcessResult result =
      RunOncard({"explore", scratch.Write("s.toml",
                                          "program = \"p.c\"\n[[thread]]\nfunction = \"t0\"\n"
                                          "[[host]]\nat_ms = 1\nset = { g = 1 }\n")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("s.toml:4:3: a scenario with [[host]] cannot be explored"));
}

TEST(Explore, TheDporEngineKnowsNoTime) {
  const ScratchFolder scratch;
  const ProcessResult result =
      RunOncard({"explore", "--engine=dpor",
                 scratch.Write("p.c", "int t0()\n{\n  GT_AxisOn(1);\n  return 0;\n}\n")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("stateful"));
}

TEST(Explore, FindsTheOrderInWhichTheAxisMovesAfterTheStop) {
  const ProcessResult result = RunOncard({"explore", kEstop + "/check_act.toml"});
  EXPECT_EQ(result.exit_code, 1);
  ExpectGolden("explore_estop.txt", Masked(result.out));
  EXPECT_EQ(RunOncard({"explore", kEstop + "/act_check.toml"}).exit_code, 0);
}

TEST(Explore, TheScheduleWithACardReplays) {
  const ScratchFolder scratch;
  const std::string saved = scratch.path() + "/estop.schedule";
  RunOncard({"explore", kEstop + "/check_act.toml", "--save", saved});
  const ProcessResult replay = RunOncard({"replay", saved, "--format=json"});
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_THAT(replay.out, HasSubstr("axis1.moving == 0 @ 100ms"));
}

// --- Choices -------------------------------------------------------------------------------------

/// An input that comes while a thread waits; it is seen when it has passed its filter.
constexpr const char* kLate =
    "program = \"p.c\"\neventually = [\"gpi[1] == 1 && clock < 4.5\"]\n[[thread]]\nfunction = "
    "\"t0\"\n[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [2, 6]\n";

TEST(ExploreChoices, AFailureIsSavedAndReplayedWithItsChoice) {
  const ScratchFolder scratch;
  const auto run = [&](std::vector<std::string> arguments) {
    return RunOncard(arguments, scratch.path());
  };
  scratch.Write("p.c", "int t0()\n{\n  GT_Delay(10);\n  return 0;\n}\n");
  scratch.Write("s.toml", kLate);
  const ProcessResult found =
      run({"explore", "s.toml", "--save", "f.schedule", "--regression", "r.toml", "--format=json"});
  EXPECT_EQ(found.exit_code, 1) << found.err;
  const Json json = Json::parse(found.out);
  const std::string choice = json["choice"];
  EXPECT_THAT(choice, StartsWith("gpi[1] = 1 at "));
  EXPECT_EQ(json["cases"], 17);
  // Only the choice is bad, so every schedule of this case is.
  const std::string ms = choice.substr(std::string("gpi[1] = 1 at ").size());
  EXPECT_THAT(scratch.Read("r.toml"), HasSubstr("at_ms = " + ms.substr(0, ms.find(' ')) + '\n'));
  EXPECT_EQ(run({"replay", "f.schedule"}).exit_code, 1);
  EXPECT_EQ(run({"test", "r.toml"}).exit_code, 1);
}

}  // namespace
}  // namespace oncard::tools
