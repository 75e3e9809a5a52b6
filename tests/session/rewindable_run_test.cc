#include "session/rewindable_run.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <atomic>

#include "runtime/observe/thread_status.h"
#include "session/views.h"
#include "tests/session/session_support.h"

namespace oncard::session {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The hashes of all moments of a run from the present to the end of its scenario.
std::vector<uint64_t> HashesToTheEnd(RewindableRun* run) {
  std::vector<uint64_t> hashes = {run->controller().Hash()};
  while (!run->Over()) {
    run->Step();
    hashes.push_back(run->controller().Hash());
  }
  return hashes;
}

/// The hash at the end of the same scenario under `oncard run`.
uint64_t HashOfWholeRun(const std::string& program, const std::string& scenario) {
  return runtime::RunForTest(program, scenario).hash;
}

/// The hash at the end of a recording.
uint64_t HashOfReplay(const std::string& program, RewindableRun* run) {
  vm::Schedule schedule = run->Record();
  runtime::RunOptions options;
  const auto scenario = runtime::ParseScenario(schedule.scenario, "recorded.toml");
  EXPECT_TRUE(scenario.ok());
  options.replay = std::make_shared<const vm::Schedule>(std::move(schedule));
  const auto result =
      runtime::RunScenario(scenario.value(), runtime::CompileForTest(program), options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message.en);
  return result.ok() ? result.value().hash : 0;
}

// --- Steps ---------------------------------------------------------------------------------------

TEST(RewindableRun, StepsAreCyclesAndStatements) {
  const auto run = RunOf(kRace, kTwoThreads);
  EXPECT_EQ(run->NextStep(), StepKind::kCycle);
  EXPECT_EQ(run->NextThread(), -1);
  EXPECT_EQ(run->Step().kind, StepKind::kCycle);
  std::vector<int> threads;
  while (run->NextStep() == StepKind::kStatement) {
    const int announced = run->NextThread();
    threads.push_back(run->Step().thread);
    EXPECT_EQ(threads.back(), announced);
  }
  EXPECT_THAT(threads, ElementsAre(0, 1, 0, 1, 0, 1));
  EXPECT_EQ(run->moment(), 7);
  EXPECT_EQ(run->Over(), runtime::RunOver::kQuiet);
}

TEST(RewindableRun, EndsInTheStateOfAWholeRun) {
  for (const auto* schedule : {"rr", "rr:3", "priority", "random:7", "pct:3:2"}) {
    const std::string scenario = "schedule = \"" + std::string(schedule) + "\"\n" + kTwoThreads;
    const auto run = RunOf(kRace, scenario);
    HashesToTheEnd(run.get());
    EXPECT_EQ(run->controller().Hash(), HashOfWholeRun(kRace, scenario)) << schedule;
  }
  const std::string move = "until_ms = 40\n";
  const auto run = RunOf(kMove, move);
  HashesToTheEnd(run.get());
  EXPECT_EQ(run->Over(), runtime::RunOver::kUntil);
  EXPECT_EQ(run->controller().Hash(), HashOfWholeRun(kMove, move));
}

TEST(RewindableRun, TakesSeveralStepsAtATimeToTheSameState) {
  const auto slow = RunOf(kMove, "until_ms = 30\n");
  const std::vector<uint64_t> hashes = HashesToTheEnd(slow.get());
  for (const int64_t moment : {1, 2, 26, 27, 1000, 2999}) {
    const auto fast = RunOf(kMove, "until_ms = 30\n");
    fast->AdvanceTo(moment);
    EXPECT_EQ(fast->moment(), moment);
    EXPECT_EQ(fast->controller().Hash(), hashes[static_cast<size_t>(moment)]) << moment;
  }
}

TEST(RewindableRun, StatementsThatNoThreadCanUseAreLost) {
  const auto run = RunOf("int x;\nint f()\n{\n  x = 1;\n  GT_Delay(2);\n  x = 2;\n}\n");
  run->Step();
  EXPECT_EQ(run->statements_left(), 25);
  run->Step();
  run->Step();
  EXPECT_EQ(run->statements_left(), 0);
  EXPECT_EQ(run->NextStep(), StepKind::kCycle);
}

TEST(RewindableRun, TheScenarioActsBetweenCycles) {
  const auto run = RunOf(kRace,
                         "expect = [\"x == 1 @ 0.25ms\"]\nuntil_ms = 1\n"
                         "[[host]]\nat_ms = 0.25\nset = { x = 7 }\n");
  while (run->NextStep() != StepKind::kHost) run->Step();
  EXPECT_EQ(run->controller().cycle(), 1);
  EXPECT_EQ(ValueOf("x", *run), 1);
  EXPECT_TRUE(run->Step().failed.empty());
  EXPECT_EQ(ValueOf("x", *run), 7);
  EXPECT_EQ(run->NextStep(), StepKind::kCycle);
}

TEST(RewindableRun, TellsOfExpectationsThatDoNotHold) {
  const auto run = RunOf(kRace, "expect = [\"x == 5 @ 0.25ms\"]\n");
  while (run->NextStep() != StepKind::kHost) run->Step();
  const StepReport report = run->Step();
  ASSERT_EQ(report.failed.size(), 1u);
  EXPECT_THAT(report.failed[0].en, AllOf(HasSubstr("x == 5 @ 0.25ms"), HasSubstr("x is 1")));
  EXPECT_EQ(run->failed(), 1);
}

TEST(RewindableRun, TellsOfRefusedCommands) {
  const auto run = RunOf("int f()\n{\n  GT_AxisOn(9);\n  return 0;\n}\n");
  run->Step();
  const StepReport report = run->Step();
  ASSERT_NE(report.refusal, nullptr);
  EXPECT_EQ(report.refusal->code, 7);
  EXPECT_THAT(report.refusal->call.en, HasSubstr("GT_AxisOn(9) = 7: "));
  ASSERT_NE(run->LastRefusal(0), nullptr);
  EXPECT_EQ(run->LastRefusal(0)->call.en, report.refusal->call.en);
  run->GoTo(1);
  EXPECT_EQ(run->LastRefusal(0), nullptr);
}

TEST(RewindableRun, KnowsWhyTheRunIsOver) {
  const auto over = [](const char* program, const char* scenario) {
    const auto run = RunOf(program, scenario);
    HashesToTheEnd(run.get());
    return *run->Over();
  };
  constexpr const char* kWait = "int go;\nint f()\n{\n  GT_WaitForVarEq(&go, 1);\n  return 0;\n}\n";
  EXPECT_EQ(over(kWait, ""), runtime::RunOver::kDeadlock);
  EXPECT_EQ(over(kWait, "[[host]]\nat_ms = 1\nset = { go = 1 }\n"), runtime::RunOver::kQuiet);
  EXPECT_EQ(over(kRace, ""), runtime::RunOver::kQuiet);
  EXPECT_EQ(over(kMove, "until_ms = 1\n"), runtime::RunOver::kUntil);
  EXPECT_EQ(over(kMove, "limit_ms = 2\n"), runtime::RunOver::kLimit);
}

TEST(RewindableRun, DoesNotStartWhatDoesNotFit) {
  const auto error = [](const std::string& scenario) {
    const auto run =
        RewindableRun::Create(runtime::ScenarioForTest(scenario), runtime::CompileForTest(kRace));
    return run.ok() ? std::string() : run.error().message.en;
  };
  EXPECT_THAT(error("[globals]\ny = 1\n"), HasSubstr("nothing is named 'y'"));
  EXPECT_THAT(error("schedule = \"fair\"\n"), HasSubstr("fair"));
  EXPECT_THAT(error("schedule = \"replay:a.sched\"\n"), HasSubstr("schedule file"));
}

// --- Back ----------------------------------------------------------------------------------------

TEST(RewindableRun, EveryMomentCanBeReachedAgain) {
  const auto run = RunOf(kMove, "until_ms = 12\n");
  const std::vector<uint64_t> hashes = HashesToTheEnd(run.get());
  for (auto moment = static_cast<int64_t>(hashes.size()) - 1; moment >= 0; moment -= 7) {
    run->GoTo(moment);
    EXPECT_EQ(run->moment(), moment);
    EXPECT_EQ(run->controller().Hash(), hashes[static_cast<size_t>(moment)]) << moment;
  }
  run->GoTo(static_cast<int64_t>(hashes.size()) + 100);
  EXPECT_EQ(run->moment(), static_cast<int64_t>(hashes.size()) - 1);
}

TEST(RewindableRun, KeepsFewStatesOfALongRun) {
  const auto run = RunOf(kMove, "until_ms = 100000\n");
  run->AdvanceTo(3'000'000);
  const uint64_t end = run->controller().Hash();
  EXPECT_LE(run->kept_count(), RewindableRun::kKeptMax);
  // Near the present the states are dense: a step back executes few steps again.
  EXPECT_LE(run->moment() - run->KeptBefore(run->moment()), RewindableRun::kKeptInterval + 32);
  run->GoTo(17);
  run->GoTo(3'000'000);
  EXPECT_EQ(run->controller().Hash(), end);
}

TEST(RewindableRun, EndsEarlyWhateverItIsAt) {
  const auto run =
      RunOf("int x;\nint f()\n{\nL:\n  x = x + 1;\n  goto L;\n}\n", "until_ms = 100000\n");
  constexpr int64_t kFar = 300'000;
  run->AdvanceTo(kFar);
  const std::atomic<bool> wanted = true;
  run->EndEarly(&wanted);
  run->GoTo(kFar - 1);
  EXPECT_LT(run->moment(), kFar - 1);
  run->GoTo(0);
  EXPECT_THAT(run->Turns(0, kFar, 1000), IsEmpty());
  EXPECT_EQ(run->Spans(0, kFar, 1000).size(), 1u);
  EXPECT_EQ(run->moment(), 0);
  run->GoToCycle(1000);
  EXPECT_LT(run->controller().cycle(), 1000);
  run->Record();
  EXPECT_EQ(run->moment(), 0);
}

// --- Warnings ------------------------------------------------------------------------------------

TEST(RewindableRun, GoingBackTakesWarningsBack) {
  const auto run = RunOf(kUnpowered);
  while (run->findings().empty()) run->Step();
  const int64_t warned = run->moment();
  EXPECT_EQ(run->last_step().kind, StepKind::kStatement);
  EXPECT_THAT(run->last_step().warning->en, HasSubstr("[drive-off]"));
  while (!run->Over()) run->Step();
  EXPECT_THAT(run->last_step().warning->en, HasSubstr("[work-left]"));
  EXPECT_THAT(WarningsOf(*run), ElementsAre("drive-off", "work-left"));
  run->GoTo(run->moment() - 1);
  EXPECT_THAT(WarningsOf(*run), ElementsAre("drive-off"));
  run->GoTo(warned - 1);
  EXPECT_THAT(WarningsOf(*run), ElementsAre());
  run->GoTo(warned);
  EXPECT_THAT(WarningsOf(*run), ElementsAre("drive-off"));
  run->GoTo(run->head());
  EXPECT_THAT(WarningsOf(*run), ElementsAre("drive-off", "work-left"));
}

TEST(RewindableRun, GoingBackTakesBackWhatTheSupervisorRemembers) {
  const auto run = RunOf(
      "int n;\nint f()\n{\n  GT_PrfTrap(1);\n  GT_SetPos(1, 100);\n  n = 1;\n}\n"
      "int g()\n{\n  GT_SetPos(1, 200);\n  n = 2;\n}\n",
      "[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = \"g\"\n");
  ASSERT_TRUE(run->StepThread(0).ok());
  const int64_t in_mode_trap = run->moment();
  ASSERT_TRUE(run->StepThread(0).ok());
  // From there, thread 1 is the first one to set a target.
  run->GoTo(in_mode_trap);
  ASSERT_TRUE(run->StepThread(1).ok());
  EXPECT_THAT(WarningsOf(*run), ElementsAre());
  ASSERT_TRUE(run->StepThread(0).ok());
  EXPECT_THAT(WarningsOf(*run), ElementsAre("two-threads"));
}

TEST(RewindableRun, WarnsAsAWholeRunDoes) {
  const auto run = RunOf(kUnpowered);
  while (!run->Over()) run->Advance(INT64_MAX);
  std::vector<std::string> texts;
  for (const runtime::CardFinding& finding : run->findings()) {
    texts.push_back(DescribeFinding(finding, "p.c").en);
  }
  std::vector<std::string> wanted;
  for (const Message& warning : runtime::RunForTest(kUnpowered, "").warnings) {
    wanted.push_back(warning.en);
  }
  EXPECT_EQ(texts, wanted);
}

TEST(RewindableRun, ForgetsWhatTheEndHasShownWhenAChangeLetsTheRunGoOn) {
  // The thread waits for ever, while the axis moves.
  const auto run = RunOf(
      "int go;\nint f()\n{\n  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n"
      "  GT_Update(1);\n  GT_WaitForVarEq(&go, 1);\n  GT_Stop(1, 0);\n  GT_Delay(100);\n}\n");
  while (!run->Over()) run->Step();
  EXPECT_EQ(run->Over(), runtime::RunOver::kDeadlock);
  EXPECT_THAT(WarningsOf(*run), ElementsAre("work-left"));
  // As long as nothing is changed it stays: the scenario's run has ended there.
  run->Step();
  EXPECT_THAT(WarningsOf(*run), ElementsAre("work-left"));
  ASSERT_TRUE(run->WriteVariable("go", 1).ok());
  const int64_t changed = run->moment();
  EXPECT_THAT(WarningsOf(*run), ElementsAre());
  while (!run->Over()) run->Step();
  EXPECT_EQ(run->Over(), runtime::RunOver::kQuiet);
  EXPECT_THAT(WarningsOf(*run), ElementsAre());
  run->GoTo(changed - 1);
  EXPECT_THAT(WarningsOf(*run), ElementsAre("work-left"));
  run->Step();
  EXPECT_THAT(WarningsOf(*run), ElementsAre());
}

TEST(RewindableRun, JudgesTheEndAgainAfterAChangeThatLeavesTheRunOver) {
  const auto run = RunOf(kUnpowered);
  while (!run->Over()) run->Step();
  ASSERT_TRUE(run->WriteVariable("n", 5).ok());
  EXPECT_THAT(WarningsOf(*run), ElementsAre("drive-off", "work-left"));
}

// --- Choices -------------------------------------------------------------------------------------

TEST(RewindableRun, TheUserChoosesTheNextThread) {
  const auto run = RunOf(kRace, kTwoThreads);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(run->StepThread(1).ok());
  EXPECT_EQ(ValueOf("x", *run), 1);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(run->StepThread(0).ok());
  EXPECT_EQ(ValueOf("x", *run), 2);
  EXPECT_EQ(HashOfReplay(kRace, run.get()), run->controller().Hash());
}

TEST(RewindableRun, AChoiceIsMadeAgainAfterGoingBack) {
  const auto run = RunOf(kRace, kTwoThreads);
  ASSERT_TRUE(run->StepThread(1).ok());
  ASSERT_TRUE(run->StepThread(1).ok());
  const uint64_t hash = run->controller().Hash();
  run->GoTo(0);
  EXPECT_EQ(run->Step().kind, StepKind::kCycle);
  EXPECT_EQ(run->NextThread(), 1);
  EXPECT_EQ(run->Step().thread, 1);
  run->Step();
  EXPECT_EQ(run->controller().Hash(), hash);
}

TEST(RewindableRun, AnotherChoiceDiscardsWhatWasAfterIt) {
  const auto run = RunOf(kRace, kTwoThreads);
  for (int i = 0; i < 5; ++i) run->Step();
  EXPECT_EQ(run->head(), 5);
  run->GoTo(1);
  // The thread that is next anyway is no choice.
  ASSERT_TRUE(run->StepThread(0).ok());
  EXPECT_EQ(run->head(), 5);
  run->GoTo(1);
  ASSERT_TRUE(run->StepThread(1).ok());
  EXPECT_EQ(run->head(), 2);
}

TEST(RewindableRun, AThreadThatCannotRunIsNotStepped) {
  const auto run = RunOf("int f()\n{\n  GT_Delay(100);\n  return 0;\n}\n");
  run->Step();
  run->Step();
  const auto waits = run->StepThread(0);
  ASSERT_FALSE(waits.ok());
  EXPECT_THAT(waits.error().message.en, HasSubstr("thread 0 cannot execute a statement now"));
  EXPECT_EQ(run->moment(), 2);
  EXPECT_THAT(run->StepThread(5).error().message.en, HasSubstr("thread 5 cannot execute"));
  EXPECT_THAT(run->StepThread(32).error().message.en, HasSubstr("threads are 0 to 31"));
  EXPECT_THAT(run->StepThread(-1).error().message.en, HasSubstr("threads are 0 to 31"));
}

TEST(RewindableRun, FollowsAScheduleUntilItEndsOrTheUserChooses) {
  runtime::RunOptions options;
  options.record = true;
  const std::string scenario = "schedule = \"random:3\"\n" + std::string(kTwoThreads);
  const auto recorded = runtime::RunForTest(kRace, scenario, options);
  const auto schedule = std::make_shared<const vm::Schedule>(*recorded.schedule);
  const auto follow = [&] {
    return RewindableRun::Create(runtime::ScenarioForTest(kTwoThreads),
                                 runtime::CompileForTest(kRace), schedule);
  };
  auto run = follow();
  ASSERT_TRUE(run.ok());
  HashesToTheEnd(run.value().get());
  EXPECT_TRUE(run.value()->follows_schedule());
  EXPECT_EQ(run.value()->controller().Hash(), recorded.hash);

  run = follow();
  run.value()->Step();
  const int other = 1 - run.value()->NextThread();
  ASSERT_TRUE(run.value()->StepThread(other).ok());
  EXPECT_FALSE(run.value()->follows_schedule());
  HashesToTheEnd(run.value().get());
  EXPECT_EQ(run.value()->Over(), runtime::RunOver::kQuiet);
}

TEST(RewindableRun, RefusesAScheduleOfAnotherProgram) {
  vm::Schedule schedule;
  schedule.program_hash = 1;
  const auto run =
      RewindableRun::Create(runtime::ScenarioForTest(kTwoThreads), runtime::CompileForTest(kRace),
                            std::make_shared<const vm::Schedule>(schedule));
  ASSERT_FALSE(run.ok());
  EXPECT_THAT(run.error().message.en, HasSubstr("another program"));
}

// --- Changes -------------------------------------------------------------------------------------

TEST(RewindableRun, AVariableIsChangedAtOnceAndAgainAfterGoingBack) {
  const auto run = RunOf(kRace, kTwoThreads);
  run->AdvanceTo(3);
  ASSERT_TRUE(run->WriteVariable("x", 40).ok());
  EXPECT_EQ(ValueOf("x", *run), 40);
  HashesToTheEnd(run.get());
  const uint64_t end = run->controller().Hash();
  const int64_t last = run->moment();
  run->GoTo(2);
  EXPECT_EQ(ValueOf("x", *run), 0);
  run->GoTo(3);
  EXPECT_EQ(ValueOf("x", *run), 40);
  run->GoTo(last);
  EXPECT_EQ(run->controller().Hash(), end);
}

TEST(RewindableRun, AChangeBetweenCyclesIsRecordedAsTheHosts) {
  const auto run = RunOf(kMove, "until_ms = 5\n");
  run->GoToCycle(0);
  while (run->controller().cycle() < 8 || run->NextStep() != StepKind::kCycle) run->Step();
  ASSERT_TRUE(run->WriteVariable("n", 1000).ok());
  EXPECT_THAT(runtime::FormatScenario(run->ScenarioWithChanges()), HasSubstr("\"n\" = 1000"));
  HashesToTheEnd(run.get());
  EXPECT_EQ(HashOfReplay(kMove, run.get()), run->controller().Hash());
}

TEST(RewindableRun, AChangeWithinACycleIsRecordedWithItsStatement) {
  const auto run = RunOf(kRace, kTwoThreads);
  run->AdvanceTo(3);
  ASSERT_TRUE(run->WriteVariable("x", 40).ok());
  EXPECT_THAT(runtime::FormatScenario(run->ScenarioWithChanges()),
              HasSubstr("[[host]]\nat_ms = 0.25\nafter_statements = 2\nset = { \"x\" = 40 }"));
  EXPECT_EQ(HashOfReplay(kRace, run.get()), run->controller().Hash());
  HashesToTheEnd(run.get());
  EXPECT_EQ(HashOfReplay(kRace, run.get()), run->controller().Hash());
}

TEST(RewindableRun, ARecordingLeavesOutWritesAfterThePresent) {
  const std::string program = "int go;\nint f()\n{\n  GT_WaitForVarEq(&go, 1);\n}\n";
  const auto run = RunOf(program);
  while (!run->Over()) run->Step();
  const int64_t end = run->moment();
  run->AdvanceTo(end + 8);
  ASSERT_TRUE(run->WriteVariable("go", 1).ok());
  run->GoTo(end);
  EXPECT_EQ(run->Over(), runtime::RunOver::kDeadlock);
  // A write that is still to come would let the recorded run go on.
  EXPECT_EQ(HashOfReplay(program, run.get()), run->controller().Hash());
}

// Without statements that can be executed the rest of the cycle is over.
TEST(RewindableRun, AChangeWithinACycleCanStopAllThreads) {
  const std::string waits =
      "int go;\nint n;\nint f()\n{\n  GT_WaitForVarEq(&go, 0);\n  n = 2;\n}\n"
      "int g()\n{\n  n = 7;\n  n = 1;\n}\n";
  const auto run = RunOf(waits,
                         "limit_ms = 5\n[[thread]]\nfunction = \"f\"\n"
                         "[[thread]]\nthread = 1\nfunction = \"g\"\n[globals]\ngo = 1\n");
  ASSERT_TRUE(run->StepThread(0).ok());
  ASSERT_TRUE(run->WriteVariable("go", 0).ok());
  ASSERT_TRUE(run->StepThread(1).ok());
  ASSERT_TRUE(run->StepThread(1).ok());
  EXPECT_GT(run->statements_left(), 0);
  ASSERT_TRUE(run->WriteVariable("go", 1).ok());
  EXPECT_EQ(run->statements_left(), 0);
  EXPECT_EQ(HashOfReplay(waits, run.get()), run->controller().Hash());
  ASSERT_TRUE(run->WriteVariable("go", 0).ok());
  EXPECT_EQ(HashOfReplay(waits, run.get()), run->controller().Hash());
  HashesToTheEnd(run.get());
  EXPECT_EQ(ValueOf("n", *run), 2);
  EXPECT_EQ(run->controller().cycle(), 2);
  EXPECT_EQ(HashOfReplay(waits, run.get()), run->controller().Hash());
}

TEST(RewindableRun, TheHostOfAScenarioWritesInTheMiddleOfACycle) {
  const std::string scenario =
      std::string(kTwoThreads) + "[[host]]\nat_ms = 0.25\nafter_statements = 3\nset = { x = 7 }\n";
  const auto run = RunOf(kRace, scenario);
  while (run->NextStep() != StepKind::kHost) run->Step();
  EXPECT_EQ(run->machine().state().executed, 3);
  EXPECT_EQ(ValueOf("x", *run), 0);
  EXPECT_EQ(run->NextThread(), -1);
  run->Step();
  EXPECT_EQ(ValueOf("x", *run), 7);
  EXPECT_EQ(run->machine().state().executed, 3);
  EXPECT_EQ(run->NextStep(), StepKind::kStatement);
  HashesToTheEnd(run.get());
  EXPECT_EQ(run->controller().Hash(), HashOfWholeRun(kRace, scenario));
  const int64_t end = run->moment();
  run->GoTo(0);
  run->AdvanceTo(end);
  EXPECT_EQ(run->controller().Hash(), HashOfWholeRun(kRace, scenario));
}

TEST(RewindableRun, PutsBackWhatTheWorldIsAboutToDo) {
  const std::string program =
      "int n;\nint f()\n{\n  int seen;\n  n = 1;\nlbl:\n  GT_GetDi(4, &seen);\n"
      "  n = n + 1;\n  if (seen) goto end;\n  goto lbl;\nend:\n  return 0;\n}\n";
  const std::string scenario =
      "[[world.react]]\nwhen = \"n >= 1\"\nafter_ms = 2\nindex = 1\nvalue = 1\n";
  const auto run = RunOf(program, scenario);
  const std::vector<uint64_t> hashes = HashesToTheEnd(run.get());
  // The condition holds at 0.25 ms; the program sees the input in the cycle up to 3 ms.
  EXPECT_EQ(run->controller().NowMs(), 3);
  EXPECT_EQ(hashes.back(), HashOfWholeRun(program, scenario));
  for (const int64_t moment : {200, 100, 5, 0}) {
    run->GoTo(moment);
    const std::vector<uint64_t> again = HashesToTheEnd(run.get());
    EXPECT_TRUE(std::equal(again.rbegin(), again.rend(), hashes.rbegin())) << moment;
  }
  EXPECT_EQ(HashOfReplay(program, run.get()), run->controller().Hash());
}

constexpr const char* kHomeSwitch =
    "until_ms = 10\n[[world.switch]]\naxis = 1\nfrom = 500\nto = 600\n";

TEST(RewindableRun, SwitchesAreMovedFromTheNextCycleOn) {
  const auto run = RunOf(kRace, kHomeSwitch);
  run->AdvanceTo(3);
  ASSERT_TRUE(run->MoveSwitch(1, -5, 5).ok());
  const int64_t moved = run->moment();
  EXPECT_EQ(run->machine().state().cycle, 1);
  HashesToTheEnd(run.get());
  EXPECT_EQ(ValueOf("home[1]", *run), 1);
  EXPECT_THAT(runtime::FormatScenario(run->ScenarioWithChanges()),
              HasSubstr("[[world.move]]\nswitch = 1\nfrom = -5\nto = 5\nat_ms = 0.25\n"));
  EXPECT_EQ(HashOfReplay(kRace, run.get()), run->controller().Hash());
  run->GoTo(moved - 1);
  run->Step();
  EXPECT_EQ(ValueOf("home[1]", *run), 0);
}

// 1000 pulses are a millimetre: 500 to 600 pulses are 0.5 to 0.6 mm.
TEST(RewindableRun, MovesSwitchesInTheUnitOfTheirAxis) {
  const auto run =
      RunOf(kRace,
            "until_ms = 10\n[[world.axis]]\naxis = 1\nunit = \"mm\"\npulses_per_unit = 1000\n"
            "[[world.switch]]\naxis = 1\nfrom = 0.5\nto = 0.6\n");
  const auto contact = [&] { return run->controller().motion().state().switches[0]; };
  EXPECT_EQ(contact().first, 500);
  run->AdvanceTo(3);
  ASSERT_TRUE(run->MoveSwitch(1, -0.25, 2).ok());
  HashesToTheEnd(run.get());
  EXPECT_EQ(contact().first, -250);
  EXPECT_EQ(contact().last, 2000);
  EXPECT_EQ(HashOfReplay(kRace, run.get()), run->controller().Hash());
  const auto shown = CardView(*run, Language::kEnglish)["switches"][0];
  EXPECT_EQ(shown["from"], -0.25);
  EXPECT_EQ(shown["to"], 2);
}

TEST(RewindableRun, RefusesMovesThatAreNone) {
  const auto run = RunOf(kRace, kHomeSwitch);
  EXPECT_THAT(run->MoveSwitch(2, 0, 1).error().message.en, HasSubstr("they are 1 to 1"));
  EXPECT_THAT(run->MoveSwitch(1, 2, 1).error().message.en, HasSubstr("greater than 'to'"));
  EXPECT_THAT(RunOf(kRace)->MoveSwitch(1, 0, 1).error().message.en, HasSubstr("has no switches"));
  // The file could not be read back.
  EXPECT_THAT(run->SetInput(motion::DiType::kHome, 1, true).error().message.en,
              HasSubstr("home[1] is wired to switch 1"));
  EXPECT_TRUE(run->SetInput(motion::DiType::kHome, 2, true).ok());
}

TEST(RewindableRun, InputsAndVoltagesChangeFromTheNextCycleOn) {
  const auto run = RunOf(kMove, "until_ms = 10\n");
  run->AdvanceTo(60);
  ASSERT_TRUE(run->SetInput(motion::DiType::kGpi, 3, true).ok());
  ASSERT_TRUE(run->SetVoltage(2, 5).ok());
  EXPECT_EQ(ValueOf("gpi[3]", *run), 0);
  HashesToTheEnd(run.get());
  EXPECT_EQ(ValueOf("gpi[3]", *run), 1);
  EXPECT_EQ(ValueOf("adc2", *run), 13107);  // 5 of 12.5 V of 32768
  EXPECT_EQ(HashOfReplay(kMove, run.get()), run->controller().Hash());
  run->GoTo(59);
  run->Step();
  EXPECT_EQ(ValueOf("gpi[3]", *run), 0);
}

TEST(RewindableRun, RefusesChangesOfWhatIsNotThere) {
  const auto run = RunOf(kRace);
  EXPECT_THAT(run->WriteVariable("y", 1).error().message.en, HasSubstr("nothing is named 'y'"));
  EXPECT_THAT(run->WriteVariable("x", 1e12).error().message.en, HasSubstr("does not fit"));
  EXPECT_THAT(run->WriteVariable("gpo", 1).error().message.en, HasSubstr("not a variable"));
  EXPECT_THAT(run->SetInput(motion::DiType::kGpi, 17, true).error().message.en,
              HasSubstr("pins 1 to 16"));
  EXPECT_THAT(run->SetVoltage(9, 1).error().message.en, HasSubstr("1 to 8"));
  EXPECT_EQ(run->moment(), 0);
}

// --- Turns ---------------------------------------------------------------------------------------

TEST(RewindableRun, ListsTheTurnsOfThreads) {
  const auto run = RunOf(kRace, "schedule = \"rr:2\"\n" + std::string(kTwoThreads));
  HashesToTheEnd(run.get());
  const int64_t end = run->moment();
  const auto turns = run->Turns(0, end, 100);
  std::vector<std::pair<int, int64_t>> listed;
  for (const auto& turn : turns) listed.emplace_back(turn.thread, turn.statements);
  EXPECT_THAT(listed,
              ElementsAre(std::pair(0, 2), std::pair(1, 2), std::pair(0, 1), std::pair(1, 1)));
  EXPECT_EQ(turns[0].moment, 1);
  EXPECT_EQ(run->moment(), end);
  EXPECT_EQ(run->Turns(0, end, 2).size(), 2u);
}

// --- Spans ---------------------------------------------------------------------------------------

/// Thread 0 waits for thread 1, which sleeps for two cycles, and then faults.
constexpr const char* kWaits =
    "int go;\nint a[3];\nint i;\n"
    "int f()\n{\n  GT_WaitForVarEq(&go, 1);\n  i = 7;\n  a[i] = 1;\n}\n"
    "int g()\n{\n  GT_Delay(2);\n  go = 1;\n}\n";
constexpr const char* kWaitsThreads =
    "cycle_us = 1000\n[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = \"g\"\n";

/// `0 running 3-7`, or `waits` instead of the state.
std::vector<std::string> Listed(const std::vector<RewindableRun::Span>& spans) {
  std::vector<std::string> list;
  for (const auto& span : spans) {
    list.push_back(fmt::format("{} {} {}-{}", span.thread,
                               span.waits ? "waits" : runtime::ThreadStateName(span.state.run),
                               span.from, span.to));
  }
  return list;
}

TEST(RewindableRun, ListsTheStatesOfThreadsOverTime) {
  const auto run = RunOf(kWaits, kWaitsThreads);
  HashesToTheEnd(run.get());
  const int64_t end = run->moment();
  // Steps: cycle, wait, delay, cycle, cycle, `go = 1`, `i = 7`, the fault.
  ASSERT_EQ(end, 8);
  const auto spans = run->Spans(0, end, 100);
  EXPECT_THAT(Listed(spans),
              ElementsAre("0 running 0-2", "1 running 0-3", "0 waits 2-6", "1 waits 3-5",
                          "1 running 5-6", "0 running 6-8", "1 finished 6-8", "0 faulted 8-8"));
  // The delay: from the first cycle to the third.
  EXPECT_EQ(spans[3].from_cycle, 1);
  EXPECT_EQ(spans[3].to_cycle, 3);
  EXPECT_EQ(spans[3].line, 12);
  EXPECT_EQ(run->moment(), end);
}

TEST(RewindableRun, ListsTheStatesOfAPartOfTheRun) {
  const auto run = RunOf(kWaits, kWaitsThreads);
  HashesToTheEnd(run.get());
  EXPECT_THAT(Listed(run->Spans(2, 4, 100)),
              ElementsAre("0 waits 2-4", "1 running 2-3", "1 waits 3-4"));
  // The fourth one would begin at moment 3.
  EXPECT_THAT(Listed(run->Spans(0, 8, 3)),
              ElementsAre("0 running 0-2", "1 running 0-3", "0 waits 2-3"));
}

TEST(RewindableRun, EachWaitIsASpanOfItsOwn) {
  const auto run = RunOf("int f()\n{\n  GT_Delay(2);\n  GT_Delay(1);\n}\n", "cycle_us = 1000\n");
  HashesToTheEnd(run.get());
  EXPECT_THAT(Listed(run->Spans(0, run->moment(), 100)),
              ElementsAre("0 running 0-2", "0 waits 2-4", "0 running 4-5", "0 waits 5-6",
                          "0 finished 6-6"));
}

}  // namespace
}  // namespace oncard::session
