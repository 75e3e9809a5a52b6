// A family that only the tests have, from its header to a replay: its hosts in C and C++ run under
// `oncard exec`, with a log, a record and a scenario.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/families/family_hosts.h"

namespace oncard::tools {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class ToyFamily : public testing::TestWithParam<const char*> {
 protected:
  /// Runs the host under `oncard exec` with some options.
  ProcessResult Exec(const std::vector<std::string>& options,
                     const std::vector<std::string>& environment = {}) const {
    return tools::Exec(std::string("toy_host_") + GetParam(), options, environment, folder_);
  }

  ScratchFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Hosts, ToyFamily, testing::Values("c", "cpp"),
                         [](const auto& language) { return std::string(language.param); });

TEST_P(ToyFamily, HasALogInVirtualTime) {
  const ProcessResult host = Exec({"--card=TOY-3"}, {"ONCARD_LOG=calls:log.txt"});
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out, "card 0\n");
  EXPECT_EQ(folder_.Read("log.txt"),
            "0.000 card0 TOY_Open(0) = 0\n"
            "0.000 card0 TOY_Call(handler) = 0\n"
            "0.050 card0 TOY_Move(3, {velocity=10, acceleration=1}) = 0\n"
            "0.100 card0 TOY_Move(4, {velocity=10, acceleration=1}) = 7: parameter axis is 4; this "
            "card has 1 to 3\n"
            "100.100 card0 TOY_Close() = 0\n");
}

TEST_P(ToyFamily, HasADefaultCardOfItsOwn) {
  EXPECT_THAT(Exec({}).err, HasSubstr("parameter axis is 3; this card has 1 to 2"));
}

TEST_P(ToyFamily, IsReplayedFromItsRecord) {
  ASSERT_EQ(Exec({"--card=TOY-3", "--record=host.calls"}).exit_code, 0);
  const std::string record = folder_.Read("host.calls");
  EXPECT_THAT(record, AllOf(HasSubstr(R"(card = \"TOY-3\")"), HasSubstr(R"("call":"TOY_Move")")));
  ExpectReplay(folder_);
  // With another velocity the card is in another state at the end.
  std::string changed = record;
  folder_.Write("host.calls", changed.replace(changed.find("[10,1]"), 6, "[11,1]"));
  EXPECT_NE(RunFamilyOncard({"replay", "host.calls"}, folder_).exit_code, 0);
  // A command oncard without the family says which cards it knows.
  folder_.Write("host.calls", record);
  EXPECT_THAT(RunOncard({"replay", "host.calls"}, folder_.path()).err,
              HasSubstr("'card' must be one of GTS-400, GTS-800, GTS-1200"));
}

/// The axis accelerates for 10 ms to 10 pulse/ms, from the first cycle after 0.05 ms on.
constexpr const char* kScenario = R"(card = "TOY-3"
expect = [
  "axis3.prfVel == 10 @ 50ms",
  "axis3.prfPos == 948 +- 3 @ 100ms",
]
)";

TEST_P(ToyFamily, MeetsTheExpectationsOfAScenario) {
  folder_.Write("move.host.toml", kScenario);
  const ProcessResult host = Exec({"--scenario=move.host.toml"});
  EXPECT_EQ(host.exit_code, 0) << host.err;
  folder_.Write("move.host.toml", std::string(kScenario) + "final = [\"axis3.prfVel == 0\"]\n");
  EXPECT_EQ(Exec({"--scenario=move.host.toml"}).exit_code, 120);
}

TEST_P(ToyFamily, RefusesTheScenarioOfAnotherFamily) {
  for (const char* scenario : {"card = \"GTS-800\"\n", "limit_ms = 1000\n"}) {
    folder_.Write("gts.host.toml", scenario);
    const ProcessResult host = Exec({"--scenario=gts.host.toml"});
    EXPECT_EQ(host.exit_code, 5) << scenario;  // open_failed
    EXPECT_THAT(host.err, HasSubstr("a card of the family gts, and the host uses libtoy: 'card' "
                                    "must be one of TOY-2, TOY-3"))
        << scenario;
  }
}

TEST_P(ToyFamily, RefusesTheCardOfAnotherFamily) {
  const ProcessResult host = Exec({"--card=GTS-800"});
  EXPECT_EQ(host.exit_code, 5);
  EXPECT_THAT(host.err, HasSubstr("ONCARD_CARD is 'GTS-800', expected one of TOY-2, TOY-3"));
}

// A hook returns the function before it. Each command but a hook is told when its card is free
// again: the call that is made meanwhile acts, and is not told.
TEST(ToyHook, HearsOfCallsAndMayMakeOthers) {
  const ScratchFolder folder;
  const ProcessResult host = Exec("toy_hook", {}, {"ONCARD_LOG=calls:log.txt"}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "TOY_Move(1, {velocity=10, acceleration=1}) = -1\n"
            "TOY_Open(0) = 0\n"
            "meanwhile 0\n"
            "TOY_Move(1, {velocity=10, acceleration=1}) = 0\n");
  EXPECT_EQ(folder.Read("log.txt"),
            "0.000 card0 TOY_Hook(hearer) = 0\n"
            "0.000 card0 TOY_Move(1, {velocity=10, acceleration=1}) = -1: card 0 is not open, call "
            "TOY_Open first\n"
            "0.000 card0 TOY_Open(0) = 0\n"
            "0.050 card0 TOY_Move(2, {velocity=5, acceleration=1}) = 0\n"
            "0.100 card0 TOY_Move(1, {velocity=10, acceleration=1}) = 0\n"
            "0.100 card0 TOY_Hook(NULL) = 0\n"
            "0.100 card0 TOY_Hook(NULL) = 0\n"
            "0.100 card0 TOY_Close() = 0\n");
}

// The call at 2.1 ms lets the third cycle end at 3 ms; then cycles take 0.04803 ms. The first one
// that does not end before 5 ms is the 45th, at 5.01726 ms. The axis moves 5 pulses in the first
// cycle and then 10 in each.
TEST(ToyCycle, ChangesWhileARunGoesOnToItsExactEnd) {
  const ScratchFolder folder;
  folder.Write("cycle.host.toml", R"(card = "TOY-3"
until_ms = 5
trace = ["axis1.prfPos"]
expect = [
  "axis1.prfPos == 25 @ 3ms",
  "axis1.prfPos == 35 @ 3.04ms",
  "axis1.prfPos == 445 @ 5ms",
]
)");
  const ProcessResult host =
      Exec("toy_cycle", {"--scenario=cycle.host.toml", "--trace=cycle.csv", "--record=host.calls"},
           {}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  const std::string trace = folder.Read("cycle.csv");
  EXPECT_THAT(trace,
              AllOf(HasSubstr("\n3,25.0\n3.048,35.0\n3.096,45.0\n"), EndsWith("\n5.017,445.0\n")));
  ExpectReplay(folder);
}

// The call begins 0.05 ms after the one before it has ended, and ends with the cycle.
TEST(ToyTick, LetsTimePassToTheEndOfTheCycle) {
  const ScratchFolder folder;
  const ProcessResult host =
      Exec("toy_tick", {"--record=host.calls"}, {"ONCARD_LOG=calls:log.txt"}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(folder.Read("log.txt"),
            "0.000 card0 TOY_Open(0) = 0\n"
            "0.050 card0 TOY_Move(1, {velocity=10, acceleration=10}) = 0\n"
            "0.100 card0 TOY_Tick(pCycle) = 0, pCycle=[1]\n"
            "1.050 card0 TOY_Tick(pCycle) = 0, pCycle=[2]\n"
            "2.050 card0 TOY_Move(2, {velocity=10, acceleration=10}) = 0\n"
            "2.050 card0 TOY_Close() = 0\n");
  ExpectReplay(folder);
}

// The scenario is over before the second cycle ends.
TEST(ToyTick, WaitsNoLongerThanTheScenarioLasts) {
  const ScratchFolder folder;
  folder.Write("tick.host.toml",
               "card = \"TOY-3\"\nuntil_ms = 1\nexpect = [\"axis1.prfPos == 5 @ 1ms\"]\n");
  const ProcessResult host = Exec("toy_tick", {"--scenario=tick.host.toml"}, {}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
}

// Axis 1 has moved 5 pulses in the first of five cycles and 10 in each other, axis 2 rests: the
// velocity of axis 2, whose array is that of axis 1, is left out.
TEST(ToySample, FillsTheArraysOfTheHost) {
  const ScratchFolder folder;
  const ProcessResult host = Exec("toy_sample", {"--record=host.calls"}, {}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out, "45 10 0\n35 10 0\n25 10 0\n-1 -1 -1\n0\n7\n0 276\n");
  // Which arrays there were is in the record, and the bytes that have been read.
  EXPECT_THAT(folder.Read("host.calls"),
              AllOf(HasSubstr("[[1,1,1,0]]"), HasSubstr("[[1,0,1,0]]"), HasSubstr("[[1,0,0,1]]"),
                    HasSubstr("[[1,20,255],3,true]")));
  ExpectReplay(folder);
}

// --- Interrupts ----------------------------------------------------------------------------------

// The handler runs after the tick and before the next one: during a sleep, after the command that
// waited for the tick has acted, in the middle of the 0.05 ms of a call, which then goes on, and
// when interrupts are enabled again. That of cycle 60 comes while the handler runs.
TEST(ToyInterrupts, RunAHandlerInsideTheCallsOfTheHost) {
  const ScratchFolder folder;
  const ProcessResult host =
      Exec("toy_handler", {"--record=host.calls"}, {"ONCARD_LOG=calls:log.txt"}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(folder.Read("log.txt"),
            "0.000 card0 TOY_Open(0) = 0\n"
            "0.000 card0 TOY_OnInterrupt(handler) = 0\n"
            "0.050 card0 TOY_Move(2, {velocity=10, acceleration=10}) = 0\n"
            "10.000 card0: interrupt in cycle 10\n"
            "10.050 card0 TOY_Sum([1], 1, pSum) = 0, pSum=[1]\n"
            "20.000 card0: interrupt in cycle 20\n"
            "19.100 card0 TOY_Tick(pCycle) = 0, pCycle=[20]\n"
            "20.050 card0 TOY_Sum([1], 1, pSum) = 0, pSum=[1]\n"
            "30.000 card0: interrupt in cycle 30\n"
            "30.050 card0 TOY_Sum([1], 1, pSum) = 0, pSum=[1]\n"
            "30.070 card0 TOY_Sum([2], 1, pSum) = 0, pSum=[2]\n"
            "40.000 card0: interrupt in cycle 40\n"
            "40.120 card0 TOY_Sum([2], 1, pSum) = 0, pSum=[2]\n"
            "40.170 card0 TOY_Sum([1], 1, pSum) = 0, pSum=[1]\n"
            "50.000 card0: interrupt in cycle 50\n"
            "50.050 card0 TOY_Sum([1], 1, pSum) = 0, pSum=[1]\n"
            "60.000 card0: interrupt in cycle 60\n"
            "62.100 card0 TOY_Sum([1], 1, pSum) = 0, pSum=[1]\n"
            "62.100 card0 TOY_OnInterrupt(NULL) = 0\n"
            "70.000 card0: interrupt in cycle 70\n"
            "72.100 card0 TOY_Close() = 0\n");
  ExpectReplay(folder);
}

TEST(ToyInterrupts, AreTheSameInEveryRun) {
  std::vector<std::string> logs;
  for (const char* host : {"toy_handler", "toy_events"}) {
    for (int run = 0; run < 2; ++run) {
      const ScratchFolder folder;
      const ProcessResult ran =
          Exec(host, {"--record=host.calls"}, {"ONCARD_LOG=calls:log.txt"}, folder);
      logs.push_back(ran.out + folder.Read("log.txt") + folder.Read("host.calls"));
    }
    EXPECT_EQ(logs.end()[-1], logs.end()[-2]) << host;
  }
}

// Both threads wait until the tick of the interrupt.
TEST(ToyInterrupts, WakeTheThreadThatWaitsForTheEvent) {
  const ProcessResult host = Exec("toy_events");
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "1: 0 at 10\n"
            "2: 0 at 20\n"
            "3: 0 at 30\n"
            "ended 0\n"
            "closed 1 1\n");
}

// The thread or the loop that waits lets the card go on: without that this would not end.
TEST(ToyInterrupts, ComeWithTheRealClock) {
  const ScratchFolder folder;
  for (const char* host : {"toy_handler", "toy_events"}) {
    const ProcessResult ran =
        RunProgram({kHostFolder + "/" + host}, folder.path(), {"ONCARD_CLOCK=real"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
  }
}

// 258 is a time-out, 4294967295 a failure. Nothing can set the event of the last wait: it fails
// after 60 s of virtual time.
TEST(ToyInterrupts, WaitsEndAsWindowsSays) {
  const ProcessResult host = Exec("toy_waits", {}, {"ONCARD_LANG=en"});
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "manual 0 at 0\n"
            "manual 0 at 0\n"
            "automatic 0 at 0\n"
            "automatic 258 at 0\n"
            "time-out 258 at 20\n"
            "thread 0 at 25\n"
            "set 0 at 25\n"
            "hopeless 4294967295 at 60025\n"
            "closed 4294967295 at 60025\n"
            "0 0\n");
  EXPECT_THAT(host.err, HasSubstr("oncard: every thread waits for an interrupt that cannot come: "
                                  "the wait fails after 60 s\n"));
}

// Both threads of the host wait, one of them for an event that does not come.
TEST(ToyInterrupts, AScenarioEndsAHostThatWaits) {
  const ScratchFolder folder;
  folder.Write("events.host.toml",
               "card = \"TOY-2\"\nuntil_ms = 15\nexpect = [\"axis2.prfPos == 95 @ 10ms\"]\n");
  const ProcessResult host = Exec("toy_events", {"--scenario=events.host.toml"}, {}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out, "1: 0 at 10\n");
}

TEST(ToyCommands, AreListed) {
  const ScratchFolder folder;
  const ProcessResult doctor = RunFamilyOncard({"doctor", "--commands", "--family=toy"}, folder);
  EXPECT_THAT(doctor.out, AllOf(HasSubstr("TOY_Move"), Not(HasSubstr("not supported"))));
}

}  // namespace
}  // namespace oncard::tools
