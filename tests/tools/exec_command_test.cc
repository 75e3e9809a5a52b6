// Host programs under `oncard exec`: the clients of tests/runtime, which are not adapted to it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files.h"
#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string Client(const std::string& name) {
  return std::string(ONCARD_BUILD_DIR "/tests/runtime/") + name;
}

/// `oncard exec options -- client arguments`.
ProcessResult Exec(const std::vector<std::string>& options,
                   const std::vector<std::string>& command) {
  std::vector<std::string> arguments = {"exec"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.push_back("--");
  arguments.insert(arguments.end(), command.begin(), command.end());
  return RunOncard(arguments);
}

// --- Cards ---------------------------------------------------------------------------------------

/// Runs the client that adds 1..100 with a card and a scenario; either may be empty.
ProcessResult ExecOnCard(const std::string& card, const std::string& scenario) {
  const ScratchFolder folder;
  folder.Write("sum.c", ReadFile(ONCARD_SOURCE_DIR "/samples/01_sum/sum.c").value());
  std::vector<std::string> arguments = {"exec"};
  if (!card.empty()) arguments.push_back("--card=" + card);
  if (!scenario.empty()) {
    folder.Write("s.toml", scenario);
    arguments.emplace_back("--scenario=s.toml");
  }
  for (const std::string& word :
       {std::string("--"), Client("one_thread_c"), std::string("sum.c")}) {
    arguments.push_back(word);
  }
  return RunOncard(arguments, folder.path());
}

TEST(ExecCard, IsTheOneOfTheOptionOrTheScenario) {
  const struct {
    const char* card;
    const char* scenario;
  } cases[] = {{"GTS-1200", "final = [\"axis12.prfPos == 0\"]\n"},
               {"", "card = \"GTS-1200\"\nfinal = [\"axis12.prfPos == 0\"]\n"},
               {"GTS-1200", "card = \"GTS-1200\"\nfinal = [\"axis12.prfPos == 0\"]\n"},
               {"GTS-1200", "axes = 12\n[[world.axis]]\naxis = 12\n"},
               {"GTS-400", ""}};
  for (const auto& c : cases) {
    const ProcessResult result = ExecOnCard(c.card, c.scenario);
    EXPECT_EQ(result.exit_code, 0) << c.card << '\n' << c.scenario << result.err;
  }
}

TEST(ExecCard, IsRefusedWhereTheyContradictEachOther) {
  const struct {
    const char* card;
    const char* scenario;
    int exit_code;
    const char* message;
  } cases[] = {
      {"GTS-500", "", 2, "GTS-500"},
      {"GTS-400", "card = \"GTS-800\"\n", 3,
       "s.toml:1:8: 'card' is GTS-800, but ONCARD_CARD is GTS-400: change or remove one of them"},
      {"GTS-400", "axes = 8\n", 3,
       "s.toml:1:8: 'axes' is 8, but the card GTS-400 has 4 axes: remove 'axes'"},
      {"GTS-400", "[[world.axis]]\naxis = 5\n", 3, "'axis' must be a whole number from 1 to 4"},
  };
  for (const auto& c : cases) {
    const ProcessResult result = ExecOnCard(c.card, c.scenario);
    EXPECT_EQ(result.exit_code, c.exit_code) << c.card << '\n' << c.scenario;
    EXPECT_THAT(result.err, HasSubstr(c.message));
  }
}

// --- Time ----------------------------------------------------------------------------------------

TEST(Exec, EverySleepTakesItsTimeAndNoMore) {
  const auto begin = std::chrono::steady_clock::now();
  const ProcessResult result = Exec({}, {Client("sleeper"), "0", "60"});
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  // In addition to the sleeps, reading a clock takes 1 us, and reading the card's clock 50 us.
  EXPECT_EQ(result.out,
            "open 0.001\n"
            "usleep 1.002\n"
            "nanosleep 251.003\n"
            "clock_nanosleep 501.004\n"
            "until 1501.006\n"
            "select 2001.007\n"
            "poll 2126.008\n"
            "sleep 62126.009\n"
            "2026-01-01 00:01:02, card 62126 ms\n");
}

/// The waits of the C and C++ library that take a time-out.
class ExecWaits : public testing::TestWithParam<const char*> {};

TEST_P(ExecWaits, EndsByVirtualTime) {
  // 2 s if nothing happens; otherwise until another thread causes the event after 300 ms.
  const ProcessResult result = Exec({}, {Client("waits"), GetParam()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "timeout 2000\ncame 300\n");
}

INSTANTIATE_TEST_SUITE_P(All, ExecWaits,
                         testing::Values("cond_realtime", "cond_monotonic", "cond_clockwait",
                                         "cnd_timedwait", "mutex_timedlock", "mutex_clocklock",
                                         "mtx_timedlock", "rwlock_timedrdlock",
                                         "rwlock_timedwrlock", "rwlock_clockrdlock",
                                         "rwlock_clockwrlock", "sem_timedwait", "sem_clockwait",
                                         "mq_timedreceive", "mq_timedsend", "poll", "ppoll",
                                         "select", "pselect", "epoll_wait", "epoll_pwait",
                                         "epoll_pwait2", "timedjoin", "clockjoin", "sigtimedwait",
                                         "cpp_condition_for", "cpp_condition_until", "cpp_future",
                                         "cpp_semaphore", "cpp_mutex", "cpp_shared_mutex"),
                         [](const auto& wait) { return std::string(wait.param); });

TEST(Exec, SleepsWithoutEndGoToTheEndOfTime) {
  EXPECT_EQ(Exec({}, {Client("waits"), "forever"}).out, "the end\n");
}

TEST(Exec, PointersThatAreNoneAreErrors) {
  const ProcessResult result = Exec({}, {Client("bad_pointers")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(Exec, TimesCountsVirtualTime) {
  EXPECT_EQ(Exec({}, {Client("waits"), "times"}).out, "150 ticks\n");
}

TEST(Exec, TimeGoesOnWithoutCancelledThreads) {
  const ProcessResult result = Exec({}, {Client("waits"), "cancel"});
  EXPECT_EQ(result.out, "4 cancelled\n") << result.err;
}

TEST(Exec, AHostOfSeveralThreadsForks) {
  const ProcessResult result = Exec({}, {Client("waits"), "fork"});
  EXPECT_EQ(result.out, "50 children\n") << result.err;
}

TEST(Exec, AMoveEndsWhereAndWhenItShould) {
  for (int run = 0; run < 2; ++run) {
    const ProcessResult result = Exec({}, {Client("trap_move")});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "50000 pulses in 1325 ms\n");
  }
}

TEST(Exec, FailsWhenTheCallLogIsLost) {
  const ProcessResult result =
      RunOncard({"exec", "--", Client("trap_move")}, {}, {"ONCARD_LOG=calls:/dev/full"});
  EXPECT_EQ(result.exit_code, 120);
  EXPECT_THAT(result.err, HasSubstr("the call log could not be written"));
}

TEST(Exec, TracesTheFirstCard) {
  const ScratchFolder scratch;
  const ProcessResult result = Exec({"--trace", scratch.path() + "/t.csv"}, {Client("trap_move")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string csv = scratch.Read("t.csv");
  EXPECT_THAT(csv, StartsWith("time_ms,axis1.prfPos,axis1.prfVel,axis1.prfAcc,"));
  EXPECT_NE(csv.find(",50000.0,0.0,0.0,"), std::string::npos) << csv.substr(csv.size() - 200);
}

TEST(Exec, LogsAndTracesWhatTheCardDoesAtPowerOn) {
  const ScratchFolder scratch;
  scratch.Write("s.toml", "[[world.input]]\ntype = \"alarm\"\nindex = 2\nvalue = 1\n");
  const ProcessResult result =
      RunOncard({"exec", "--scenario=s.toml", "--trace=t.json", "--", Client("trap_move")},
                scratch.path(), {"ONCARD_LOG=calls"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string alarm = "the drive of axis 2 reports an alarm at 0: it is switched off";
  EXPECT_THAT(result.err, HasSubstr("0.000 card0: " + alarm));
  EXPECT_THAT(scratch.Read("t.json"), HasSubstr("{\"name\":\"" + alarm + "\",\"cat\":\"card\""));
}

TEST(Exec, ATraceWithoutAScenarioSetsNoLimit) {
  const ScratchFolder scratch;
  // 62 s of the card; the limit of a run is 60 s.
  const ProcessResult result =
      Exec({"--trace", scratch.path() + "/t.csv"}, {Client("sleeper"), "7", "60"});
  EXPECT_EQ(result.exit_code, 7) << result.err;
  EXPECT_THAT(scratch.Read("t.csv"), HasSubstr("\n62126"));
}

TEST(Exec, LeavesTheTraceToTheParentOfAChild) {
  const ScratchFolder scratch;
  const std::string trace = scratch.path() + "/t.csv";
  EXPECT_EQ(Exec({"--trace", trace}, {Client("memory"), "close"}).exit_code, 0);
  const std::string alone = scratch.Read("t.csv");
  EXPECT_THAT(alone, StartsWith("time_ms"));
  const ProcessResult result = Exec({"--trace", trace}, {Client("memory"), "late"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(scratch.Read("t.csv"), alone);
}

TEST(Exec, DrawsTheFirstCard) {
  if (!std::filesystem::exists("/usr/bin/gnuplot")) {
    GTEST_SKIP() << "gnuplot is not installed: apt-get install gnuplot-nox";
  }
  const ScratchFolder scratch;
  const ProcessResult result = Exec({"--plot", scratch.path() + "/t.svg"}, {Client("trap_move")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(scratch.Read("t.svg"), HasSubstr("axis1.prfVel"));
  EXPECT_FALSE(scratch.Has("t.svg.gnuplot"));
}

TEST(Exec, ThreadsOfTheHostShareTheTime) {
  const ProcessResult result = Exec({}, {Client("two_card_moves")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(Exec, TheRealClockIsTheWallClock) {
  const auto begin = std::chrono::steady_clock::now();
  const ProcessResult result = Exec({"--clock=real"}, {Client("sleeper"), "0", "1"});
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, Not(HasSubstr("2026-01-01 00:00:0")));
}

TEST(Exec, WorksThroughAShell) {
  const ProcessResult result =
      Exec({}, {"sh", "-c", Client("sleeper") + " 0 100 && echo shell goes on"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("card 102126 ms\nshell goes on\n"));
}

// --- Keys ----------------------------------------------------------------------------------------

TEST(Exec, PressesKeys) {
  // 10 pulse/ms for 500 ms, 30 for 500 ms; the ramps of 1 pulse/ms^2 take 50 and 200 pulses off,
  // and there are 450 more until the axis is at rest. The host's loop reads each key up to 10 ms
  // later.
  const ProcessResult result = Exec({"--keys=500:++,1000:q,1500:x"}, {Client("windows_style")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  int pulses = 0;
  int ticks = 0;
  double seconds = 0;
  ASSERT_EQ(std::sscanf(result.out.c_str(), "%d pulses, %d ms, %lf s\npress any key\n", &pulses,
                        &ticks, &seconds),
            3)
      << result.out;
  EXPECT_NEAR(pulses, 500 * 10 - 50 + 500 * 30 - 200 + 450, 400);
  EXPECT_NEAR(ticks, 1000, 25);
  EXPECT_NEAR(seconds, 1, 0.025);
  EXPECT_EQ(result.out, Exec({"--keys=500:++,1000:q,1500:x"}, {Client("windows_style")}).out);
}

TEST(Exec, TakesKeysFromTheScenario) {
  const ScratchFolder folder;
  const std::string scenario = folder.Write("keys.toml", "keys = [{at_ms = 300, text = \"q\"}]\n");
  const ProcessResult result = Exec({"--scenario=" + scenario}, {Client("windows_style")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr(" 0.3"));
}

/// Runs the host `keys` with empty standard input.
ProcessResult ExecWithoutInput(const std::vector<std::string>& options, const std::string& mode) {
  std::string command = "exec \"$0\" exec";
  for (const std::string& option : options) command += " " + option;
  return RunProgram({"sh", "-c", command + " -- \"$1\" \"$2\" < /dev/null",
                     ONCARD_BUILD_DIR "/bin/oncard", Client("keys"), mode});
}

TEST(Exec, TheEndOfTheInputIsNoKey) {
  EXPECT_EQ(ExecWithoutInput({}, "until_hit").out, "100 looks\n");
  // Characters in a pipe are keys.
  const ProcessResult piped = RunProgram({"sh", "-c", "printf ab | \"$0\" exec -- \"$1\" until_hit",
                                          ONCARD_BUILD_DIR "/bin/oncard", Client("keys")});
  EXPECT_EQ(piped.out, "a\nb\n100 looks\n");
}

TEST(Exec, AHostMayWaitForALastKeyThatDoesNotCome) {
  const ProcessResult result = ExecWithoutInput({}, "last");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "press any key\n");
}

TEST(Exec, AHostThatGoesOnAskingForKeysFails) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, std::vector<std::string>{"--keys=10:a"}}) {
    const ProcessResult result = ExecWithoutInput(options, "until_q");
    EXPECT_EQ(result.exit_code, 121);
    EXPECT_EQ(result.out, options.empty() ? "begins\n" : "begins\na\n");
    EXPECT_EQ(result.err,
              "oncard: the host has asked 1000 times for a key after the last one; add the keys "
              "that make it end (--keys, ONCARD_KEYS or the scenario)\n");
  }
}

// --- Output --------------------------------------------------------------------------------------

TEST(Exec, ShowsGbkAsUtf8) {
  struct Case {
    const char* gbk;  // as in printf of the shell
    const char* shown;
  };
  const Case cases[] = {
      {R"(pos 1\n)", "pos 1\n"},
      {R"(\316\273\326\303 1\r)", "位置 1\r"},
      {R"(\316)", ""},                  // half a character is none
      {R"(\377\377!\n)", "\uFFFD!\n"},  // no character
      {R"(\316\n)", "\uFFFD\n"},        // broken by the end of the line
  };
  for (const Case& c : cases) {
    EXPECT_EQ(Exec({"--gbk"}, {"printf", c.gbk}).out, c.shown) << c.gbk;
  }
  // A character in two parts, and the exit code.
  const ProcessResult result =
      Exec({"--gbk"}, {"sh", "-c", R"(printf '\316'; sleep 0.01; printf '\273\n'; exit 7)"});
  EXPECT_EQ(result.out, "位\n");
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_EQ(Exec({"--gbk"}, {"./nothing"}).exit_code, 3);
}

// --- Scenarios -----------------------------------------------------------------------------------

constexpr const char* kInputAt500 =
    "expect = [\"gpo[1] == 0 @ 499ms\", \"gpo[1] == 1 @ 510ms\", \"gpo[1] == 1\"]\n"
    "[[world.input]]\ntype = \"gpi\"\nindex = 1\nvalue = 1\nat_ms = 500\n";

TEST(Exec, PutsTheHostIntoTheWorldOfAScenario) {
  const ScratchFolder folder;
  const std::string scenario = folder.Write("s.toml", kInputAt500);
  const ProcessResult result = Exec({"--scenario=" + scenario}, {Client("watched"), "0"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("input 1 at 50"));
}

TEST(Exec, ReportsWhatIsNotAsExpectedWithAnExitCodeOfItsOwn) {
  const ScratchFolder folder;
  const std::string scenario = folder.Write(
      "s.toml",
      "expect = [\"gpo[1] == 1 @ 100ms\", \"clock > 10 @ 1h\", \"gpo == 2\", \"nothing == 1\"]\n");
  EXPECT_EQ(Exec({"--scenario=" + scenario}, {Client("watched"), "0"}).exit_code, 3);

  const std::string right = folder.Write("r.toml",
                                         "expect = [\"gpo[1] == 1 @ 100ms\", \"clock > 10 @ "
                                         "3600s\", \"gpo == 2\", \"nothing == 1\"]\n");
  const ProcessResult result = Exec({"--scenario=" + right}, {Client("watched"), "0"});
  EXPECT_EQ(result.exit_code, 120);
  EXPECT_THAT(result.out, HasSubstr("input 0")) << "its own output is complete";
  EXPECT_THAT(result.err,
              HasSubstr("oncard: card 0: 'gpo[1] == 1 @ 100ms' does not hold: gpo[1] is 0\n"));
  EXPECT_THAT(result.err, HasSubstr("'clock > 10 @ 3600s' does not hold: the host ended before"));
  EXPECT_THAT(result.err, HasSubstr("'gpo == 2' does not hold: gpo is 1\n"));
  EXPECT_THAT(result.err, HasSubstr("oncard: " + right +
                                    ":1:68: card 0: nothing is named 'nothing'\n"
                                    "    1 | expect = ["));
}

TEST(Exec, NamesWhatItCannotTraceEvenWithoutATrace) {
  const ScratchFolder folder;
  const std::string scenario = folder.Write("s.toml", "trace = [\"axis1.prfPos\", \"do.gpo1\"]\n");
  const ProcessResult result = Exec({"--scenario=" + scenario}, {Client("watched"), "0"});
  EXPECT_EQ(result.exit_code, 120);
  EXPECT_THAT(result.err, HasSubstr("oncard: " + scenario + ":1:26: nothing is named 'do.gpo1'\n"));
}

TEST(Exec, LeavesTheHostsOwnFailureAlone) {
  const ScratchFolder folder;
  const std::string scenario = folder.Write("s.toml", "expect = [\"gpo == 2\"]\n");
  for (const int code : {1, 9}) {
    EXPECT_EQ(Exec({"--scenario=" + scenario}, {Client("watched"), std::to_string(code)}).exit_code,
              code);
  }
}

// --- The vendor's headers ------------------------------------------------------------------------

TEST(Exec, RunsAHostOfTheVendorsBasicHeader) {
  const ProcessResult result = Exec({}, {Client("vendor_basic")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  // The host tests how a NULL structure is handled.
  EXPECT_EQ(result.err,
            "oncard: warning: card 0: GT_SetTrigger(1, NULL) = 7: parameter pTrigger is NULL; pass "
            "the address of a variable (at 0.45 ms)\n"
            "oncard: warning: card 0: GT_GetTrigger(1, NULL) = 7: parameter pTrigger is NULL; pass "
            "the address of a variable (at 0.5 ms)\n"
            "oncard: warning: card 0: GT_SetTrigger(0, {encoder=2, probeType=1, probeIndex=3, "
            "sense=0, offset=40, loop=0, windowOnly=1, firstPosition=-1000000, "
            "lastPosition=2000000}) = 7: parameter i is 0; the range is [1, 12] (at 0.55 ms)\n");
}

TEST(Exec, SaysThatAHostHasTheVendorsHeaderOfSeveralCards) {
  struct Case {
    const char* cards;
    const char* tries;
    const char* code;
    const char* command;
  };
  const Case cases[] = {
      {"0", "axis", "7\n", "GT_AxisOn"},     {"0", "file", "7\n", "GT_LoadConfig"},
      {"1", "file", "7\n", "GT_LoadConfig"}, {"0", "clock", "7\n", "GT_GetClock"},
      {"1", "clock", "7\n", "GT_GetClock"},  {"01", "nothing", "-6\n", "GT_Open"},
  };
  for (const Case& c : cases) {
    const ProcessResult result = Exec({}, {Client("vendor_multi"), c.cards, c.tries});
    EXPECT_EQ(result.out, c.code) << c.cards << c.tries;
    EXPECT_EQ(result.err.rfind(std::string("oncard: ") + c.command +
                               " seems to have been called with a card number"),
              0u)
        << c.cards << c.tries << result.err;
  }
  // GT_Open(0, 0) alone proves nothing: single-card hosts also call it.
  EXPECT_EQ(Exec({}, {Client("vendor_multi"), "0", "nothing"}).err, "");
}

// --- The end ------------------------------------------------------------------------------------

// `watched` reads an input for 2 s.
TEST(Exec, EndsTheHostWhenTheScenarioEnds) {
  const ScratchFolder folder;
  const std::string scenario =
      folder.Write("s.toml", "until_ms = 200\nexpect = [\"clock == 200\"]\n");
  const ProcessResult good = Exec({"--scenario=" + scenario, "--trace=" + folder.path() + "/t.csv"},
                                  {Client("watched"), "9"});
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_THAT(folder.Read("t.csv"), HasSubstr("\n200\n"));
  const std::string limited = folder.Write("l.toml", "limit_ms = 200\n");
  const ProcessResult bad = Exec({"--scenario=" + limited}, {Client("watched"), "0"});
  EXPECT_EQ(bad.exit_code, 120);
  EXPECT_THAT(bad.err, HasSubstr("card 0: the host still runs at the time limit of 200 ms"));
}

TEST(Exec, EndsAHostThatOnlyWaits) {
  const ScratchFolder folder;
  const std::string scenario = folder.Write("s.toml", "until_ms = 1000\n");
  // It calls the card once in 62 s.
  const ProcessResult result = Exec({"--scenario=" + scenario}, {Client("sleeper"), "7", "60"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST(Exec, AGlobalObjectOfTheHostMayCallTheCardAtTheEnd) {
  const ScratchFolder folder;
  folder.Write("sum.c", ReadFile(ONCARD_SOURCE_DIR "/samples/01_sum/sum.c").value());
  const std::vector<std::string> commands[] = {
      {Client("global_object")},
      {ONCARD_BUILD_DIR "/bin/oncard", "exec", "--trace=t.csv", "--record=h.calls", "--",
       Client("global_object")}};
  for (const std::vector<std::string>& command : commands) {
    const ProcessResult result = RunProgram(command, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "the end\nfailed 0, unsupported 8\n");
  }
  EXPECT_THAT(folder.Read("t.csv"), StartsWith("time_ms"));
  EXPECT_THAT(folder.Read("h.calls"), HasSubstr("\"close\""));
}

TEST(Exec, SaysWhichCallsWereRefused) {
  const ProcessResult result = Exec({}, {Client("refused")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("oncard: warning: card 0: GT_AxisOn(9) = 7: "));
  EXPECT_THAT(result.err, HasSubstr(", 3 times)\n"));
  const ProcessResult strict = Exec({"--strict-commands"}, {Client("refused")});
  EXPECT_EQ(strict.exit_code, 120);
  EXPECT_THAT(strict.err, HasSubstr("oncard: card 0: GT_AxisOn(9) = 7: "));
}

TEST(Exec, CountsRefusedCallsByReason) {
  const ProcessResult few = Exec({}, {Client("refused"), "2"});
  EXPECT_THAT(few.err, HasSubstr("GT_ClrSts(100, 1) = 7: parameter axis is 100; the range is "));
  EXPECT_THAT(few.err, HasSubstr("GT_ClrSts(101, 1) = 7: parameter axis is 101; the range is "));
  EXPECT_THAT(few.err, Not(HasSubstr("other reasons")));
  const ProcessResult many = Exec({}, {Client("refused"), "30"});
  EXPECT_THAT(many.err, HasSubstr("GT_ClrSts(107, 1) = 7: parameter axis is 107; "));
  EXPECT_THAT(many.err, Not(HasSubstr("GT_ClrSts(108, 1)")));
  // 30 reasons, each twice, of which 8 are told apart. Calls take 50 us: GT_Open, four of the
  // others and two for each of the eight come before.
  EXPECT_THAT(many.err, HasSubstr("warning: card 0: GT_ClrSts = 7 for other reasons (first at 1.05 "
                                  "ms, 44 times)\n"));
}

TEST(Exec, SpeaksTheLanguageOfTheOption) {
  const ProcessResult chinese =
      RunOncard({"--lang=zh", "exec", "--", Client("refused")}, {}, {"LC_ALL=C"});
  EXPECT_THAT(chinese.err, HasSubstr("oncard: 警告：卡 0：GT_AxisOn(9) = 7: "));
  const ProcessResult english =
      RunOncard({"--lang=en", "exec", "--", Client("refused")}, {}, {"LC_ALL=zh_CN.UTF-8"});
  EXPECT_THAT(english.err, HasSubstr("oncard: warning: card 0: GT_AxisOn(9) = 7: "));
}

TEST(Exec, SaysWhatCannotBeMeant) {
  const ProcessResult result = Exec({}, {Client("careless")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("oncard: warning: card 0: GT_Update(0x3): the mask starts axis "
                                    "1, 2, for which nothing has been set; the mask of axis 3 is "
                                    "4 (at "));
  EXPECT_THAT(result.err, HasSubstr("card 0: GT_Update(0x8): axis 4 moves while its drive is off"));
  EXPECT_THAT(result.err, HasSubstr("card 0: GT_Update(0x8): axis 4 still moves at the end of the "
                                    "run"));
  const ProcessResult silent =
      Exec({"-Wno-drive-off", "-Wno-update-mask", "-Wno-work-left"}, {Client("careless")});
  EXPECT_EQ(silent.exit_code, 0);
  EXPECT_EQ(silent.err, "");
  EXPECT_EQ(Exec({"--strict-commands"}, {Client("careless")}).exit_code, 120);
}

class ExecSignalTest : public testing::TestWithParam<int> {};

TEST_P(ExecSignalTest, WritesTheTraceBeforeTheHostEnds) {
  const ScratchFolder folder;
  const ProcessResult result = InterruptOncard({"exec", "--trace=t.csv", "--", Client("endless")},
                                               GetParam(), folder.path());
  EXPECT_EQ(result.exit_code, 128 + GetParam()) << result.err;
  EXPECT_THAT(folder.Read("t.csv"), StartsWith("time_ms"));
}

INSTANTIATE_TEST_SUITE_P(Signals, ExecSignalTest, testing::Values(SIGINT, SIGTERM, SIGHUP));

class ExecKeyTest : public testing::TestWithParam<const char*> {};

TEST_P(ExecKeyTest, IsRefusedInAScenarioOfAHost) {
  const ScratchFolder folder;
  const std::string scenario = folder.Write("s.toml", GetParam());
  const ProcessResult result = Exec({"--scenario=" + scenario}, {Client("watched"), "0"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("cannot be used with a host program"));
}

INSTANTIATE_TEST_SUITE_P(Keys, ExecKeyTest,
                         testing::Values("program = \"p.c\"", "include = []", "double = \"16.16\"",
                                         "schedule = \"rr\"", "races = \"none\"", "sync = []",
                                         "explore = \"prove\"", "[globals]\nx = 1",
                                         "[[thread]]\nfunction = \"f\"",
                                         "[[host]]\nset = { x = 1 }"));

// --- Exit codes ----------------------------------------------------------------------------------

TEST(Exec, PassesTheExitCodeOn) {
  EXPECT_EQ(Exec({}, {Client("sleeper"), "42", "0"}).exit_code, 42);
}

TEST(Exec, SaysWhatIsWrong) {
  struct Case {
    std::vector<std::string> options;
    std::string host;
    int code;
    std::string says;
  };
  const ScratchFolder folder;
  const std::string text = folder.Write("text", "no program\n");
  const std::string bad = folder.Write("bad.toml", "expcet = []\n");
  const Case cases[] = {
      {{}, "./nothing", 3, "oncard: cannot run './nothing': No such file or directory\n"},
      {{}, text, 3, "oncard: cannot run '" + text + "': Permission denied\n"},
      {{"--scenario=nothing.toml"}, "true", 3, "nothing.toml"},
      {{"--scenario=" + bad}, "true", 3, "did you mean 'expect'?"},
      {{"--clock=fast"}, "true", 2, "--clock is 'fast', expected virtual, real or real:SCALE\n"},
      {{"--keys=q"}, "true", 2, "the keys are 'q', expected MS:TEXT"},
  };
  for (const Case& c : cases) {
    const ProcessResult result = Exec(c.options, {c.host});
    EXPECT_EQ(result.exit_code, c.code) << c.says;
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr(c.says));
  }
  EXPECT_EQ(RunOncard({"exec"}).exit_code, 2);
}

}  // namespace
}  // namespace oncard::tools
