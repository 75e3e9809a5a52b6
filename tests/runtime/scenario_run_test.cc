#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/scenario/run/requirement_watch.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kWait = "int go;\nint f()\n{\n  GT_WaitForVarEq(&go, 1);\n  return 1;\n}\n";

/// The first line of the error.
std::string ErrorOf(const std::string& program, const std::string& scenario) {
  const auto result = RunScenario(ScenarioForTest(scenario), CompileForTest(program));
  if (result.ok()) return "no error";
  const std::string& told = result.error().message.en;
  return told.substr(0, told.find('\n'));
}

TEST(RunScenario, RunsTheFirstFunctionWithoutThreads) {
  const ScenarioResult result = RunForTest(kCount, "");
  ASSERT_EQ(result.threads.size(), 1u);
  EXPECT_EQ(result.threads[0].function, "f");
  EXPECT_EQ(result.threads[0].status.en, "finished, result 0");
  EXPECT_EQ(result.end, RunEnd::kQuiet);
  EXPECT_EQ(result.statements, 2);
}

TEST(RunScenario, SetsGlobalsAndLocalsBeforeTheStart) {
  const ScenarioResult result =
      RunForTest(kCount,
                 "[globals]\nn = 10\n[[thread]]\nthread = 2\nfunction = \"f\"\npage = 5\n"
                 "init = { k = 4 }\n");
  EXPECT_EQ(result.threads[0].page, 5);
  EXPECT_EQ(result.threads[0].result, "14");
}

TEST(RunScenario, SaysWhatDoesNotFitTheProgram) {
  const std::string thread = "[[thread]]\nfunction = \"f\"\n";
  EXPECT_EQ(ErrorOf(kCount, "[[thread]]\nfunction = \"ff\"\n"),
            "t.toml:3:12: the program has no function 'ff'; did you mean 'f'?");
  EXPECT_EQ(ErrorOf(kCount, "[[thread]]\nfunction = \"other\"\n"),
            "t.toml:3:12: the program has no function 'other': it has f");
  EXPECT_EQ(ErrorOf(kCount, thread + "init = { j = 1 }\n"), "t.toml:4:10: nothing is named 'j'");
  EXPECT_EQ(ErrorOf(kCount, thread + "init = { k = 1e12 }\n"),
            "t.toml:4:10: 1000000000000 does not fit 'page0.k'");
  EXPECT_EQ(ErrorOf(kCount, "[globals]\nn = [1, 2]\n"), "t.toml:3:1: 'n' takes 1 values, not 2");
  EXPECT_EQ(ErrorOf(kCount, "[globals]\ngpo = 1\n"),
            "t.toml:3:1: 'gpo' is not a variable of the program");
  EXPECT_EQ(ErrorOf(kCount, thread + "[[thread]]\nthread = 1\npage = 0\nfunction = \"f\"\n"),
            "t.toml:6:8: thread 1 cannot have page 0: another thread has it");
  EXPECT_EQ(ErrorOf(kCount, "expect = [\"m == 1\"]"), "t.toml:2:11: nothing is named 'm'");
}

RunOptions WithSteps() {
  RunOptions options;
  options.steps = true;
  return options;
}

TEST(RunScenario, LogsWhatItsStatementsDo) {
  const Scenario scenario = ScenarioForTest("[[thread]]\nfunction = \"f\"\ninit = { k = 4 }\n");
  const ScenarioResult result = RunScenario(scenario, CompileForTest(kCount), WithSteps()).value();
  ASSERT_TRUE(result.steps);
  ASSERT_EQ(result.steps->steps.size(), 2u);
  const vm::Object& object = result.steps->image->object;
  const LoggedStep& add = result.steps->steps[0];
  EXPECT_EQ(add.line, 4);
  ASSERT_EQ(add.reads.size(), 2u);
  EXPECT_EQ(NameOf(add, add.reads[1].slot, object), "k");
  EXPECT_EQ(ValueText(add, add.reads[1].slot, add.reads[1].raw, object), "4");
  ASSERT_EQ(add.writes.size(), 1u);
  EXPECT_EQ(NameOf(add, add.writes[0].slot, object), "n");
  EXPECT_EQ(add.writes[0].before, 0);
  EXPECT_EQ(add.writes[0].after, 4);
}

/// Under every policy a run with a step log is the same as without.
TEST(RunScenario, ALogDoesNotChangeTheRun) {
  const std::string program =
      "int n, a[3];\nint f(int k)\n{\n  int cc;\n  int q;\nlbl:\n  n = n + 1;\n  a[k] = n;\n"
      "  cc = a[k] < 500;\n  if (cc) goto lbl;\n  GT_Delay(2);\n  q = n / k;\n  return q;\n}\n";
  for (const char* policy : {"rr", "rr:7", "priority", "random:3", "pct:5:3"}) {
    const Scenario scenario =
        ScenarioForTest(std::string("schedule = \"") + policy + "\"\n" +
                        "[[thread]]\nthread = 0\nfunction = \"f\"\ninit = { k = 0 }\n"
                        "[[thread]]\nthread = 1\nfunction = \"f\"\ninit = { k = 1 }\n"
                        "[[thread]]\nthread = 2\nfunction = \"f\"\ninit = { k = 2 }\n");
    const auto plain = RunScenario(scenario, CompileForTest(program));
    const auto logged = RunScenario(scenario, CompileForTest(program), WithSteps());
    ASSERT_TRUE(plain.ok() && logged.ok());
    EXPECT_EQ(logged.value().hash, plain.value().hash) << policy;
    EXPECT_EQ(logged.value().end_ms, plain.value().end_ms) << policy;
    // The division by zero is logged too, although that statement is not completed.
    EXPECT_GE(static_cast<int64_t>(logged.value().steps->steps.size()), plain.value().statements)
        << policy;
  }
}

TEST(RunScenario, FailsAtTheTimeLimit) {
  const ScenarioResult result = RunForTest(kSpin, "limit_ms = 2");
  EXPECT_EQ(result.end, RunEnd::kTimeLimit);
  EXPECT_EQ(result.end_ms, 2);
  ASSERT_EQ(result.failures.size(), 1u);
  EXPECT_EQ(result.failures[0].message.en, "threads still run at the time limit of 2 ms");
  EXPECT_THAT(result.threads[0].status.en, StartsWith("running at p.c:"));
}

TEST(RunScenario, EndsWithoutFailureAtUntil) {
  const ScenarioResult result = RunForTest(kSpin, "until_ms = 1\nexpect = [\"n == 50\"]");
  EXPECT_TRUE(result.passed());
  EXPECT_TRUE(result.reached_until);
}

TEST(RunScenario, ADeadlockThatIsAllowedEndsTheRun) {
  EXPECT_FALSE(RunForTest(kWait, "").passed());
  const ScenarioResult result = RunForTest(kWait, "deadlock = \"any\"\nexpect = [\"go == 0\"]\n");
  EXPECT_TRUE(result.passed());
  EXPECT_EQ(result.end, RunEnd::kDeadlock);
  // What must hold at the end is checked there.
  EXPECT_FALSE(RunForTest(kWait, "deadlock = \"any\"\nexpect = [\"go == 1\"]\n").passed());
}

TEST(RunScenario, ARunThatMayLastForEverIsCutByTheLimit) {
  EXPECT_TRUE(RunForTest(kSpin, "endless = true\nlimit_ms = 2\n").passed());
  const std::string may_last = "livelock = \"any\"\nlimit_ms = 2\n";
  EXPECT_THAT(RunForTest(kSpin, may_last).warnings, testing::IsEmpty());
  // This is not the end of which the expectation speaks.
  const ScenarioResult result = RunForTest(kSpin, may_last + "expect = [\"n == 0\"]\n");
  EXPECT_TRUE(result.passed());
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_EQ(result.warnings[0].en,
            "threads still run at the time limit of 2 ms, which is allowed here: what must hold at "
            "the end of the run was not checked");
  // It does speak of the end of a run that ends.
  EXPECT_FALSE(RunForTest(kCount, may_last + "expect = [\"n == 9\"]\n").passed());
}

// --- The end of a run ----------------------------------------------------------------------------

// 0.5 pulse/ms^2 to 35 pulse/ms takes 70 ms.
constexpr const char* kJog =
    "int f()\n{\n  TJogPrm jog;\n  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_GetJogPrm(1, &jog);\n"
    "  jog.acc = 0.5;\n  jog.dec = 0.5;\n  GT_SetJogPrm(1, &jog);\n  GT_SetVel(1, 35);\n"
    "  GT_Update(1);\n  return 0;\n}\n";

TEST(RunScenario, GoesOnUntilTheEndThatIsAskedForWithoutThreads) {
  const ScenarioResult result = RunForTest(kJog, "until_ms = 500\nexpect = [\"clock == 500\"]");
  EXPECT_TRUE(result.passed());
  EXPECT_TRUE(result.reached_until);
  EXPECT_EQ(result.end_ms, 500);
}

TEST(RunScenario, TracesUntilTheEndThatIsAskedFor) {
  RunOptions options;
  options.trace = true;
  const ScenarioResult result =
      RunForTest(kJog, "until_ms = 60\ntrace = [\"axis1.prfVel\"]", options);
  EXPECT_EQ(result.trace->rows().last().time_us, 60'000);
}

TEST(RunScenario, SaysThatAnAxisStillMovesAtTheEnd) {
  const ScenarioResult result = RunForTest(kJog, "until_ms = 500");
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_THAT(
      result.warnings[0].en,
      HasSubstr(": axis 1 still moves at the end of the run, at 500 ms: velocity 35 pulse/ms, "));
  EXPECT_TRUE(RunForTest(kCount, "until_ms = 500").warnings.empty());
}

TEST(RunScenario, FailsWhenTheLimitComesBeforeTheEndThatIsAskedFor) {
  const ScenarioResult result = RunForTest(kCount, "limit_ms = 20\nuntil_ms = 30");
  EXPECT_EQ(result.end, RunEnd::kTimeLimit);
  ASSERT_EQ(result.failures.size(), 1u);
  EXPECT_EQ(result.failures[0].message.en,
            "the time limit of 20 ms is before the end required by 'until_ms', 30 ms: increase "
            "'limit_ms'");
}

TEST(RunScenario, SaysThatTheHostCameTooLate) {
  const ScenarioResult result = RunForTest(kCount, "[[host]]\nat_ms = 10\nset = { n = 1 }\n");
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_EQ(result.warnings[0].en,
            "the run ended at 0.25 ms, before the host writes n at 10 ms: 'until_ms' makes it last "
            "longer");
}

TEST(RunScenario, NamesLateEventsOnlyWhereUntilMsMakesItLastLonger) {
  const std::string late = "[[world.input]]\nvalue = 1\nat_ms = 100\n";
  const ScenarioResult quiet = RunForTest(kCount, late);
  ASSERT_EQ(quiet.warnings.size(), 1u);
  EXPECT_EQ(quiet.warnings[0].en,
            "the run ended at 0.25 ms, before [[world.input]] at 100 ms: 'until_ms' makes it last "
            "longer");
  EXPECT_EQ(RunForTest(kSpin, "until_ms = 5\n" + late).warnings.size(), 1u);
  const ScenarioResult limited = RunForTest(kSpin, "limit_ms = 5\n" + late);
  EXPECT_EQ(limited.end, RunEnd::kTimeLimit);
  EXPECT_TRUE(limited.warnings.empty());
  const ScenarioResult stuck = RunForTest(kWait, late);
  EXPECT_EQ(stuck.end, RunEnd::kDeadlock);
  EXPECT_TRUE(stuck.warnings.empty());
}

TEST(RunScenario, NamesNoMissedWriteAfterTheTimeLimit) {
  const ScenarioResult limited =
      RunForTest(kSpin, "limit_ms = 5\n[[host]]\nat_ms = 10\nset = { n = 1 }\n");
  EXPECT_EQ(limited.end, RunEnd::kTimeLimit);
  EXPECT_TRUE(limited.warnings.empty());
}

TEST(RunScenario, StopsOnRequestAndKeepsItsResults) {
  const std::atomic<bool> stop = true;
  RunOptions options;
  options.stop = &stop;
  options.trace = true;
  options.record = true;
  const ScenarioResult result = RunForTest(kSpin, "expect = [\"n == -1\"]", options);
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(result.end_ms, 0);
  EXPECT_TRUE(result.failures.empty());
  EXPECT_TRUE(result.trace && result.schedule);
}

TEST(RunScenario, GoesOnAfterTheThreadsUntilTheLastInstant) {
  const ScenarioResult result =
      RunForTest(kCount, "expect = [\"clock == 20 @ 20ms\", \"thread0.run == 0 @ 20ms\"]");
  EXPECT_TRUE(result.passed());
  EXPECT_EQ(result.end_ms, 20);
}

TEST(RunScenario, ReportsInstantsThatWereNotReached) {
  const ScenarioResult result = RunForTest(kSpin, "until_ms = 5\nexpect = [\"n > 0 @ 6ms\"]");
  ASSERT_EQ(result.failures.size(), 1u);
  EXPECT_EQ(result.failures[0].message.en, "the run ended before, at 5 ms");
}

TEST(RunScenario, EvaluatesAnInstantBeforeTheInputsOfThatInstant) {
  // The filter takes three cycles: the change at 1 ms takes effect at 1.75 ms.
  const ScenarioResult result = RunForTest(
      kSpin,
      "until_ms = 3\nexpect = [\"gpi == 0 @ 1ms\", \"gpi == 0 @ 1.5ms\", \"gpi == 5 @ 1.75ms\"]\n"
      "[[world.input]]\nvalue = 5\nat_ms = 1\n");
  EXPECT_TRUE(result.passed()) << result.failures[0].message.en;
}

TEST(RunScenario, FailsOnAFaultUnlessItIsExpected) {
  const char* program = "int f(int k)\n{\n  k = 1 / k;\n  return k;\n}\n";
  const ScenarioResult unexpected = RunForTest(program, "");
  ASSERT_EQ(unexpected.failures.size(), 1u);
  EXPECT_EQ(unexpected.failures[0].message.en, "thread 0 f: fault at p.c:3: division by zero");
  EXPECT_TRUE(RunForTest(program, "expect = [\"thread0.error == 100\"]").passed());
}

TEST(RunScenario, DescribesFaultsWithTheirValues) {
  const ScenarioResult output =
      RunForTest("int a[2];\nint f(int k)\n{\n  GT_GetClock(&a[0], &a[k]);\n  return k;\n}\n",
                 "[[thread]]\nfunction = \"f\"\ninit = { k = -1 }\n");
  EXPECT_EQ(output.threads[0].status.en,
            "fault at p.c:4: index -1 is out of bounds: the array has elements 0 to 1");
}

TEST(RunScenario, NoticesADeadlock) {
  const ScenarioResult result = RunForTest(kWait, "");
  EXPECT_EQ(result.end, RunEnd::kDeadlock);
  EXPECT_FALSE(result.passed());
  EXPECT_THAT(result.threads[0].status.en, StartsWith("waiting at p.c:"));
}

TEST(RunScenario, StartsPeriodicThreadsAnew) {
  const ScenarioResult result = RunForTest(
      kCount,
      "until_ms = 9.5\nexpect = [\"n == 5\"]\n[[thread]]\nfunction = \"f\"\nperiod_ms = 2\n"
      "init = { k = 1 }\n");
  EXPECT_TRUE(result.passed()) << result.failures[0].message.en;
}

TEST(RunScenario, IsDeterministic) {
  const char* scenario =
      "schedule = \"random:5\"\nuntil_ms = 4\n[[thread]]\nfunction = \"f\"\n"
      "[[thread]]\nthread = 1\nfunction = \"f\"\n";
  EXPECT_EQ(RunForTest(kSpin, scenario).hash, RunForTest(kSpin, scenario).hash);
}

TEST(RunScenario, ReplaysWhatItRecorded) {
  const std::string threads =
      "until_ms = 4\n[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\n"
      "function = \"f\"\n";
  RunOptions record;
  record.record = true;
  const ScenarioResult first = RunForTest(kSpin, "schedule = \"random:9\"\n" + threads, record);
  ASSERT_TRUE(first.schedule.has_value());
  RunOptions replay;
  replay.replay = std::make_shared<const vm::Schedule>(*first.schedule);
  const ScenarioResult second = RunForTest(kSpin, threads, replay);
  EXPECT_TRUE(second.passed());
  EXPECT_EQ(second.hash, first.hash);
}

/// A run of a program that is stopped at the first check, and the replay of its recording.
TEST(RunScenario, ReplaysARecordingThatWasCutOffToWhereItWas) {
  constexpr const char* kWaits = "int n;\nint f()\n{\n  n = 1;\n  GT_Delay(1000);\n  n = 2;\n}\n";
  for (const char* program : {kSpin, kWaits}) {
    std::atomic<bool> stop = false;
    /// Stops the run as soon as it has begun.
    class StopAtOnce : public RunWatch {
     public:
      explicit StopAtOnce(std::atomic<bool>* stop) : stop_(stop) {}
      void Begin(const Controller&, ScenarioErrors*) override {}
      bool ObservesStates() const override { return true; }
      void ObserveState(const Controller& controller) override {
        if (controller.cycle() > 0) *stop_ = true;
      }
      void End(const Controller&) override {}

     private:
      std::atomic<bool>* stop_;
    } watch(&stop);
    RunOptions record;
    record.record = true;
    record.stop = &stop;
    record.watch = &watch;
    const ScenarioResult first = RunForTest(program, "", record);
    ASSERT_TRUE(first.interrupted);
    EXPECT_EQ(first.schedule->cut_us, 250'000);
    RunOptions replay;
    replay.replay = std::make_shared<const vm::Schedule>(*first.schedule);
    const ScenarioResult second = RunForTest(program, "expect = [\"n == -1\"]\n", replay);
    EXPECT_TRUE(second.passed());
    EXPECT_TRUE(second.interrupted);
    EXPECT_EQ(second.hash, first.hash);
    EXPECT_EQ(second.end_ms, first.end_ms);
    ASSERT_EQ(second.warnings.size(), 1u);
    EXPECT_EQ(second.warnings[0].en,
              fmt::format("the recording ends at 250 ms, after statement {}: the recorded run was "
                          "interrupted there, and so is this replay",
                          first.statements));
  }
}

TEST(RunScenario, NoticesThatAReplayLeavesARecordingThatWasCutOff) {
  vm::Schedule schedule;
  RunOptions record;
  record.record = true;
  schedule = *RunForTest(kCount, "", record).schedule;
  schedule.cut_us = 10'000;
  RunOptions replay;
  replay.replay = std::make_shared<const vm::Schedule>(schedule);
  const ScenarioResult result = RunForTest(kCount, "[globals]\nn = 1\n", replay);
  EXPECT_EQ(result.end, RunEnd::kScheduleDiverged);
  EXPECT_FALSE(result.passed());
}

TEST(RunScenario, NoticesThatAReplayEndsElsewhere) {
  RunOptions record;
  record.record = true;
  const ScenarioResult first = RunForTest(kCount, "", record);
  RunOptions replay;
  replay.replay = std::make_shared<const vm::Schedule>(*first.schedule);
  const ScenarioResult second = RunForTest(kCount, "[globals]\nn = 1\n", replay);
  EXPECT_EQ(second.end, RunEnd::kScheduleDiverged);
  EXPECT_FALSE(second.passed());
}

// --- The host ------------------------------------------------------------------------------------

TEST(Host, WritesVariablesWhileTheProgramRuns) {
  const ScenarioResult result = RunForTest(
      "int go;\nint seen;\nint f()\n{\n  int cc;\nlbl:\n  cc = go == 0;\n  if (cc) goto lbl;\n"
      "  seen = go;\n  return 0;\n}\n",
      "expect = [\"seen == 0 @ 10ms\", \"seen == 5 @ 10.25ms\"]\n"
      "[[host]]\nat_ms = 10\nset = { go = 5 }\n");
  EXPECT_TRUE(result.passed()) << result.failures.front().message.en;
}

TEST(Host, EndsAWaitThatNothingElseCanEnd) {
  constexpr const char* kWaits =
      "int go;\nint f()\n{\n  GT_WaitForVarEq(&go, 1);\n  return 7;\n}\n";
  for (const bool traced : {false, true}) {
    RunOptions options;
    options.trace = traced;
    const ScenarioResult result =
        RunForTest(kWaits, "[[host]]\nat_ms = 10\nset = { go = 1 }\n", options);
    EXPECT_EQ(result.end, RunEnd::kQuiet);
    EXPECT_EQ(result.threads[0].result, "7");
  }
  EXPECT_EQ(RunForTest(kWaits, "[[host]]\nat_ms = 10\nset = { go = 2 }\n").end, RunEnd::kDeadlock);
}

// Every thread counts, 25 statements in a cycle.
constexpr const char* kCounts =
    "int n;\nint go;\nint seen;\nint f()\n{\nl:\n  n = n + 1;\n  goto l;\n}\n"
    "int g()\n{\n  GT_WaitForVarEq(&go, 1);\n}\n";

/// The result of kCounts with a scenario, however it is run.
ScenarioResult RunCounts(const std::string& scenario) {
  const ScenarioResult plain = RunForTest(kCounts, scenario);
  RunOptions options;
  options.trace = options.steps = options.record = true;
  const ScenarioResult watched = RunForTest(kCounts, scenario, options);
  EXPECT_EQ(watched.hash, plain.hash) << scenario;
  options = {};
  options.replay = std::make_shared<const vm::Schedule>(*watched.schedule);
  const Scenario observed = ScenarioForTest("always = [\"n >= 0\"]\n" + scenario);
  const auto replayed = RunWithRequirements(observed, CompileForTest(kCounts), options);
  EXPECT_TRUE(replayed.ok());
  EXPECT_EQ(replayed.ok() ? replayed.value().hash : 0, plain.hash) << scenario;
  EXPECT_TRUE(plain.passed()) << scenario;
  return plain;
}

TEST(Host, WritesInTheMiddleOfACycle) {
  // f increments n with every other statement: 13 times in the first cycle, 12 times in the second.
  const auto n_after = [](const std::string& keys) {
    const ScenarioResult result = RunCounts("until_ms = 0.5\n[[host]]\nset = { n = 100 }\n" + keys);
    return result.values[0].elements[0];
  };
  EXPECT_EQ(n_after("at_ms = 0.25\n"), "112");
  EXPECT_EQ(n_after("at_ms = 0.25\nafter_statements = 24\n"), "113");
  EXPECT_EQ(n_after("at_ms = 0.25\nafter_statements = 20\n"), "115");
  EXPECT_EQ(n_after("at_ms = 0.25\nafter_statements = 0\n"), "125");
  EXPECT_EQ(n_after("at_ms = 0.5\nafter_statements = 23\n"), "101");
}

TEST(Host, WritesInTheOrderOfTheStatements) {
  const ScenarioResult result = RunCounts(
      "until_ms = 0.25\n[[host]]\nat_ms = 0.25\nafter_statements = 8\nset = { seen = 1 }\n"
      "[[host]]\nat_ms = 0.25\nset = { go = 5 }\n"
      "[[host]]\nat_ms = 0.2\nafter_statements = 3\nset = { seen = 2, go = 4 }\n");
  EXPECT_EQ(result.values[1].elements[0], "5");
  EXPECT_EQ(result.values[2].elements[0], "1");
}

TEST(Host, WakesAThreadInTheMiddleOfACycle) {
  const auto run = [](const std::string& after, const std::string& expected) {
    return RunCounts("until_ms = 1\nexpect = [\"thread0.run == " + expected +
                     " @ 0.25ms\"]\n[[thread]]\nfunction = \"g\"\n[[host]]\nat_ms = 0.25\n" +
                     "set = { go = 1 }\nafter_statements = " + after + "\n");
  };
  // At the end of its function the thread ends without a further statement.
  EXPECT_EQ(run("1", "0").threads[0].statements, 1);
  // It waits after its only statement: three are not executed.
  EXPECT_EQ(run("3", "1").threads[0].run, vm::ThreadRun::kStopped);
}

TEST(Host, WritesAtTheEndOfACycleThatIsTooShort) {
  const ScenarioResult result =
      RunForTest("int go;\nint seen;\nint f()\n{\n  GT_WaitForVarEq(&go, 1);\n  seen = go;\n}\n",
                 "expect = [\"go == 0 @ 0.25ms\", \"seen == 1\"]\n"
                 "[[host]]\nat_ms = 0.25\nafter_statements = 9\nset = { go = 1 }\n");
  EXPECT_TRUE(result.passed()) << result.failures.front().message.en;
  EXPECT_EQ(result.end_ms, 0.5);
}

TEST(Host, CannotWriteUnknownVariablesOrValuesThatDoNotFit) {
  const vm::Object object = CompileForTest("int go;\nint f()\n{\n  return 0;\n}\n");
  for (const char* set : {"{ gpo = 1 }", "{ goo = 1 }", "{ go = 3e9 }", "{ go = [1, 2] }"}) {
    const Scenario scenario = ScenarioForTest(std::string("[[host]]\nset = ") + set);
    EXPECT_FALSE(RunScenario(scenario, object).ok()) << set;
  }
}

}  // namespace
}  // namespace oncard::runtime
