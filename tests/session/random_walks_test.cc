// A session may be driven in any way: in the end its state and its warnings are those that straight
// execution of what it recorded leads to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/random.h"
#include "runtime/scenario/run/requirement_watch.h"
#include "tests/base/random_cases.h"
#include "tests/session/session_support.h"

namespace oncard::session {
namespace {

struct Walked {
  std::string name;
  std::string program;
  std::string scenario;
};

// Threads that race, wait for each other and for the host, sleep, fault and start periodically,
// with and without axes that move, or move axes as nobody means it.
std::vector<Walked> Programs() {
  const std::string threads =
      "[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 3\nfunction = \"g\"\n";
  return {
      {"race", kRace, kTwoThreads},
      {"random policy", kRace, "schedule = \"random:11\"\n" + std::string(kTwoThreads)},
      {"axis", kMove,
       "until_ms = 60\n[[world.input]]\ntype = \"gpi\"\nindex = 1\nvalue = 1\nat_ms = 3\n"
       "[[world.switch]]\naxis = 1\ntype = \"limit_positive\"\nfrom = 800\n"},
      {"handover",
       "int go;\nint n;\nint f()\n{\n  GT_WaitForVarEq(&go, 1);\n  n = n + 1;\n  go = 0;\n}\n"
       "int g()\n{\n  int i;\n  int c;\nloop:\n  i = i + 1;\n  GT_Delay(1);\n  c = i < 9;\n"
       "  if (c) goto loop;\n  go = 1;\n  n = n * 2;\n}\n",
       "schedule = \"pct:5:3\"\nlimit_ms = 50\n" + threads +
           "[[host]]\nat_ms = 2\nset = { n = 100 }\n"
           "[[host]]\nat_ms = 3\nafter_statements = 4\nset = { n = 7, go = 1 }\n"
           "[[host]]\nat_ms = 3\nafter_statements = 4\nset = { go = 0 }\n"},
      {"periodic",
       "int n;\nint a[4];\nint f()\n{\n  n = n + 1;\n  a[n] = n;\n}\nint g()\n{\n  int i;\nloop:\n"
       "  i = i + 1;\n  goto loop;\n}\n",
       "until_ms = 12\n[[thread]]\nfunction = \"f\"\nperiod_ms = 2\n"
       "[[thread]]\nthread = 3\nfunction = \"g\"\n"},
      {"warnings",
       "int n;\nint f()\n{\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n  GT_Update(1);\n"
       "  GT_WaitForVarEq(&n, 2);\n  GT_Update(2);\n}\n"
       "int g()\n{\n  int i;\n  int c;\n  GT_PrfTrap(2);\nloop:\n  i = i + 1;\n"
       "  GT_SetPos(2, i);\n  GT_Delay(1);\n  GT_Update(2);\n  c = i < 9;\n"
       "  if (c) goto loop;\n}\n",
       "limit_ms = 30\n" + threads +
           "[[world.switch]]\naxis = 1\ntype = \"limit_positive\"\nfrom = 100\n"},
  };
}

constexpr const char* kAwaited = "statements == 61 && clock < 30";
constexpr const char* kAsked = "statements == 40 -> statements == 61 && clock < 30";

/// What the supervisor warns of up to the present, with what only the end shows or without.
std::vector<std::string> WarningTexts(const RewindableRun& run, bool with_end) {
  std::vector<std::string> texts;
  for (const runtime::CardFinding& finding : run.findings()) {
    if (finding.at_end && !with_end) continue;
    texts.push_back(DescribeFinding(finding, ProgramPath(run.scenario())).en);
  }
  return texts;
}

/// What it warns of in a whole run.
std::vector<std::string> WarningTexts(const runtime::ScenarioResult& result) {
  std::vector<std::string> texts;
  for (const Message& warning : result.warnings) {
    const auto names = [&warning](const runtime::CardWarningInfo& info) {
      return warning.en.ends_with(fmt::format(" [{}]", info.name));
    };
    if (std::ranges::any_of(runtime::CardWarningTable(), names)) texts.push_back(warning.en);
  }
  return texts;
}

class RandomWalk {
 public:
  RandomWalk(const Walked& walked, uint64_t seed)
      : walked_(walked),
        session_(SessionOf(walked.program, "eventually = [\"" + std::string(kAwaited) +
                                               "\"]\nleads = [\"" + kAsked + "\"]\n" +
                                               walked.scenario)),
        random_(seed) {}

  /// Takes random steps in both directions, with choices and changes.
  void Go() {
    const uint64_t moves = 5 + Draw(40);
    for (uint64_t i = 0; i < moves; ++i) Move();
    // A recording ends where the scenario has acted.
    while (run().NextStep() == StepKind::kHost) run().Step();
  }

  RewindableRun& run() { return session_.run(); }

  /// The state to which the recording leads.
  uint64_t HashOfRecording() {
    const auto schedule = std::make_shared<const vm::Schedule>(run().Record());
    const auto scenario = runtime::ParseScenario(schedule->scenario, "recorded.toml");
    EXPECT_TRUE(scenario.ok()) << (scenario.ok() ? "" : scenario.error().message.en);
    if (!scenario.ok()) return 0;
    runtime::RunOptions options;
    options.replay = schedule;
    const auto result = runtime::RunWithRequirements(
        scenario.value(), runtime::CompileForTest(walked_.program), options);
    EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message.en);
    if (!result.ok()) return 0;
    EXPECT_EQ(HashOfSecondSession(scenario.value(), schedule), result.value().hash);
    if (IsJudged(scenario.value())) {
      EXPECT_EQ(WarningTexts(run(), true), WarningTexts(result.value()));
      const auto& failures = result.value().failures;
      const auto fails = [&failures](const char* how) {
        return std::ranges::any_of(failures, [how](const runtime::ScenarioFailure& failure) {
          return failure.message.en.find(how) != std::string::npos;
        });
      };
      EXPECT_EQ(run().HasHeld(0), !fails("held in no state"));
      EXPECT_EQ(run().OwedTo(0).pending, fails("neither then nor later"));
    }
    return result.value().hash;
  }

 private:
  /// True if the recorded run judges the same states as the session has.
  bool IsJudged(const runtime::Scenario& recorded) {
    const bool over =
        run().Over() == runtime::RunOver::kQuiet || run().Over() == runtime::RunOver::kUntil;
    return over && recorded.until_us == run().scenario().until_us;
  }

  /// The state after as much of the recording as this session has seen.
  uint64_t HashOfSecondSession(const runtime::Scenario& scenario,
                               std::shared_ptr<const vm::Schedule> schedule) {
    auto second = RewindableRun::Create(scenario, runtime::CompileForTest(walked_.program),
                                        std::move(schedule));
    EXPECT_TRUE(second.ok());
    if (!second.ok()) return 0;
    RewindableRun& other = *second.value();
    const auto behind = [&] {
      return std::pair(other.controller().cycle(), other.machine().state().executed) <
             std::pair(run().controller().cycle(), run().machine().state().executed);
    };
    while (behind()) other.Step();
    while (other.NextStep() == StepKind::kHost) other.Step();
    EXPECT_EQ(WarningTexts(run(), false), WarningTexts(other, false));
    return other.controller().Hash();
  }

  uint64_t Draw(uint64_t bound) { return RandomBelow(random_, bound); }

  void Move() {
    Walk walk;
    walk.thread = Draw(2) == 0 ? 0 : 3;
    walk.budget = 1 + static_cast<int64_t>(Draw(400));
    switch (Draw(13)) {
      case 0:
      case 1:
        run().Step();
        break;
      case 2:
        run().AdvanceTo(run().moment() + static_cast<int64_t>(Draw(300)));
        break;
      case 3:
        static_cast<void>(run().StepThread(walk.thread));
        break;
      case 4:
        run().GoTo(static_cast<int64_t>(Draw(static_cast<uint64_t>(run().head()) + 1)));
        break;
      case 5:
        run().GoTo(run().moment() - 1);
        break;
      case 6:
        walk.goal = Goal::kCycle;
        static_cast<void>(session_.Forward(walk, nullptr));
        break;
      case 7:
        walk.goal = Draw(2) == 0 ? Goal::kCycle : Goal::kLine;
        static_cast<void>(session_.Back(walk));
        break;
      case 8:
        walk.goal = Goal::kStatement;
        static_cast<void>(session_.Forward(walk, nullptr));
        break;
      case 9:
        static_cast<void>(session_.Forward(walk, nullptr));
        break;
      case 10:
        static_cast<void>(run().WriteVariable(Variable(), static_cast<double>(Draw(3))));
        break;
      case 11: {
        const auto from = static_cast<double>(Draw(3000));
        static_cast<void>(run().MoveSwitch(1, from, from + static_cast<double>(Draw(500))));
        break;
      }
      default:
        static_cast<void>(
            run().SetInput(motion::DiType::kGpi, 1 + static_cast<int>(Draw(16)), Draw(2) == 0));
        break;
    }
  }

  std::string Variable() {
    if (walked_.program == kRace) return "x";
    return walked_.program.starts_with("int go") && Draw(2) == 0 ? "go" : "n";
  }

  const Walked& walked_;
  Session session_;
  uint64_t random_;
};

TEST(RandomWalks, EndWhereStraightExecutionDoes) {
  const char* wanted = std::getenv("ONCARD_WALKS");
  const int walks = wanted == nullptr ? RandomCases(200) : std::atoi(wanted);
  for (const Walked& walked : Programs()) {
    for (int seed = 0; seed < walks; ++seed) {
      RandomWalk walk(walked, static_cast<uint64_t>(seed));
      walk.Go();
      const uint64_t hash = walk.run().controller().Hash();
      ASSERT_EQ(walk.HashOfRecording(), hash) << walked.name << ", seed " << seed;
      // Going back and forth does not matter.
      const int64_t moment = walk.run().moment();
      const auto warnings = WarningTexts(walk.run(), true);
      walk.run().GoTo(moment / 2);
      walk.run().GoTo(moment);
      ASSERT_EQ(walk.run().controller().Hash(), hash) << walked.name << ", seed " << seed;
      ASSERT_EQ(WarningTexts(walk.run(), true), warnings) << walked.name << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace oncard::session
