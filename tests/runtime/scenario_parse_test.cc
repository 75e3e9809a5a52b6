#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/scenario/file/scenario.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kFull = R"(# everything there is
program = "sum.c"
include = ["inc", "../common"]
double = "16.16"
schedule = "random:7"
rate = 200
cycle_us = 1000
limit_ms = 500
until_ms = 12.5
expect = ["sum == 3", "gpo == 1 @ 2ms"]
final = ["sum == 3 || sum == 4"]
always = ["sum < 100"]
never = ["gpo == 2 && sum == 1"]
eventually = ["sum == 4"]
livelock = "any"
deadlock = "any"
races = "benign"
sync = ["flag", "a"]
explore = { engine = "stateful", verdict = "PASSED", max_states = 1000, runs = 7, follow = "x.schedule" }

[globals]
sum = 0
"a[1]" = -2
b = [1, 2.5, 3]

[[thread]]
thread = 3
function = "add"
init = { begin = 1, end = 100 }

[[thread]]
thread = 4
function = "add"
page = 9
period_ms = 20
priority = 2

[[world.input]]
type = "home"
value = 5
at_ms = 7.25

[[world.input]]
index = 2
value = 1
at_ms = 5
)";

Scenario Parse(const std::string& text) {
  auto scenario = ParseScenario(text, "dir/s.toml");
  EXPECT_TRUE(scenario.ok()) << (scenario.ok() ? "" : scenario.error().message.en);
  return scenario.ok() ? scenario.value() : Scenario();
}

/// All errors, with excerpts.
std::string ErrorsOf(const std::string& text, ScenarioUse use = ScenarioUse::kText) {
  const auto scenario = ParseScenario(text, "s.toml", use);
  return scenario.ok() ? "no error" : scenario.error().message.en;
}

/// The headline of the first error.
std::string ErrorOf(const std::string& text) {
  const std::string errors = ErrorsOf(text);
  return errors.substr(0, errors.find('\n'));
}

TEST(ParseScenario, ReadsHowToExplore) {
  const Scenario s = Parse(kFull);
  EXPECT_EQ(s.final, std::vector<std::string>{"sum == 3 || sum == 4"});
  EXPECT_EQ(s.always, std::vector<std::string>{"sum < 100"});
  EXPECT_EQ(s.never, std::vector<std::string>{"gpo == 2 && sum == 1"});
  EXPECT_EQ(s.eventually, std::vector<std::string>{"sum == 4"});
  EXPECT_FALSE(s.endless);
  EXPECT_EQ(s.livelock, "any");
  EXPECT_EQ(s.deadlock, "any");
  EXPECT_EQ(s.races, "benign");
  EXPECT_EQ(s.sync, (std::vector<std::string>{"flag", "a"}));
  EXPECT_EQ(s.explore, (ExploreWish{"stateful", "PASSED", 0, 7, 1000, "x.schedule"}));
  EXPECT_EQ(Parse("program = \"p.c\"\nexplore = \"prove\"\n").explore, ExploreWish{});
  EXPECT_FALSE(Parse("program = \"p.c\"\n").explore);
}

TEST(ParseScenario, ReadsEverything) {
  const Scenario s = Parse(kFull);
  EXPECT_EQ(s.program, "sum.c");
  EXPECT_EQ(s.include_folders, (std::vector<std::string>{"inc", "../common"}));
  EXPECT_EQ(s.double_format, vm::DoubleFormat::k16_16);
  EXPECT_EQ(s.schedule, "random:7");
  EXPECT_EQ(s.rate, 200);
  EXPECT_EQ(s.cycle_us, 1000);
  EXPECT_EQ(s.limit_ms, 500);
  EXPECT_EQ(s.until_us, 12500);
  ASSERT_EQ(s.expectations.size(), 2u);
  EXPECT_EQ(s.expectations[1].at_us, 2000);
  ASSERT_EQ(s.globals.size(), 3u);
  EXPECT_EQ(s.globals[1], (InitialValue{"a[1]", {-2}}));
  EXPECT_EQ(s.globals[2], (InitialValue{"b", {1, 2.5, 3}}));
  ASSERT_EQ(s.threads.size(), 2u);
  EXPECT_EQ(s.threads[0], (ThreadStart{3, "add", 3, {{"begin", {1}}, {"end", {100}}}, 0, 4}));
  EXPECT_EQ(s.threads[1], (ThreadStart{4, "add", 9, {}, 20, 2}));
}

TEST(ParseScenario, SortsTheWorldByTime) {
  const Scenario s = Parse(kFull);
  ASSERT_EQ(s.world.inputs.size(), 2u);
  EXPECT_EQ(s.world.inputs[0], (InputEvent{5000, motion::DiType::kGpi, 2, 1}));
  EXPECT_EQ(s.world.inputs[1], (InputEvent{7250, motion::DiType::kHome, 0, 5}));
}

TEST(ParseScenario, ReadsTheHostsWritesAndWhatATraceHolds) {
  const Scenario s = Parse(
      "program = \"p.c\"\ntitle = \"Two axes\"\ntrace = [\"axis1.prfPos\", \"gpo\"]\n"
      "[[host]]\nat_ms = 20\nset = { stop = 1 }\n"
      "[[host]]\nat_ms = 10\nset = { go = 1, a = [2, 3] }\n");
  EXPECT_EQ(s.title, "Two axes");
  EXPECT_EQ(s.trace, (std::vector<std::string>{"axis1.prfPos", "gpo"}));
  ASSERT_EQ(s.host.size(), 2u);
  EXPECT_EQ(s.host[0], (HostEvent{10000, {{"go", {1}}, {"a", {2, 3}}}}));
  EXPECT_EQ(s.host[1], (HostEvent{20000, {{"stop", {1}}}}));
  const Scenario again = Parse(FormatScenario(s));
  EXPECT_EQ(again.host, s.host);
  EXPECT_EQ(again.title, s.title);
  EXPECT_EQ(again.trace, s.trace);
}

TEST(ParseScenario, ReadsWritesInTheMiddleOfACycle) {
  const Scenario s = Parse(
      "program = \"p.c\"\n[[host]]\nat_ms = 10\nafter_statements = 24\nset = { go = 1 }\n"
      "[[host]]\nat_ms = 10\nset = { go = 2 }\n");
  ASSERT_EQ(s.host.size(), 2u);
  EXPECT_EQ(s.host[0], (HostEvent{10000, {{"go", {1}}}, 24}));
  EXPECT_EQ(s.host[1].after_statements, std::nullopt);
  EXPECT_EQ(Parse(FormatScenario(s)).host, s.host);
}

TEST(ParseScenario, RefusesWritesAfterStatementsThatThereAreNot) {
  const auto refusal = [](const std::string& text) {
    const auto parsed =
        ParseScenario("program = \"p.c\"\n" + text + "set = { go = 1 }\n", "s.toml");
    return parsed.ok() ? Message() : parsed.error().message;
  };
  const Message many = refusal("rate = 99\n[[host]]\nat_ms = 1\nafter_statements = 25\n");
  EXPECT_THAT(many.en, StartsWith("s.toml:5:20: a cycle has at most 25 statements"));
  EXPECT_THAT(many.zh, HasSubstr("一个周期至多 25 条语句"));
  EXPECT_EQ(refusal("rate = 99\n[[host]]\nat_ms = 1\nafter_statements = 24\n").en, "");
  EXPECT_THAT(refusal("[[host]]\nafter_statements = 3\n").en,
              HasSubstr("no statement is executed at 0 ms: the first cycle is at 0.25 ms"));
  EXPECT_THAT(refusal("[[host]]\nat_ms = 1\nafter_statements = -1\n").en,
              HasSubstr("'after_statements' must be a whole number from 0 to 3999999"));
  EXPECT_THAT(refusal("[[host]]\nat_ms = 1\nafter_statements = 1.5\n").en,
              HasSubstr("'after_statements' must be a whole number"));
}

TEST(ParseScenario, HasDefaults) {
  const Scenario s = Parse("program = \"p.c\"\n");
  EXPECT_EQ(s.schedule, "rr");
  EXPECT_EQ(s.rate, 100);
  EXPECT_EQ(s.cycle_us, 250);
  EXPECT_EQ(s.limit_ms, 60000);
  EXPECT_FALSE(s.until_us.has_value());
  EXPECT_EQ(s.double_format, vm::DoubleFormat::k32_16);
}

TEST(FormatScenario, IsReadBackAsTheSame) {
  const Scenario first = Parse(kFull);
  const std::string text = FormatScenario(first);
  const Scenario second = Parse(text);
  EXPECT_EQ(FormatScenario(second), text);
  EXPECT_EQ(second.threads, first.threads);
  EXPECT_EQ(second.globals, first.globals);
  EXPECT_EQ(second.world, first.world);
  EXPECT_EQ(second.until_us, first.until_us);
}

TEST(FormatScenario, QuotesWhatTomlQuotes) {
  Scenario s;
  s.program = "a\"b\\c\n轴.c";
  EXPECT_EQ(Parse(FormatScenario(s)).program, s.program);
}

struct BadCase {
  const char* text;
  const char* error;
};

class BadScenarioTest : public testing::TestWithParam<BadCase> {};

TEST_P(BadScenarioTest, IsRejectedAtItsPlace) {
  EXPECT_EQ(ErrorOf(GetParam().text), GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    Scenarios, BadScenarioTest,
    testing::Values(
        BadCase{"program = \"p.c\"\nrat = 5\n",
                "s.toml:2:1: unknown key 'rat'; did you mean 'rate'?"},
        BadCase{"program = \"p.c\"\n[[thread]]\nfunction = \"f\"\npag = 1\n",
                "s.toml:4:1: unknown key 'pag'; did you mean 'page'?"},
        BadCase{"program = \"p.c\"\n[[world.input]]\nvalue = 1\nwhen = 5\n",
                "s.toml:4:1: unknown key 'when': expected one of type, index, value, at_ms, "
                "between_ms"},
        BadCase{"program = 5\n", "s.toml:1:11: 'program' must be a string"},
        BadCase{"program = \"p.c\"\nrate = 0\n",
                "s.toml:2:8: 'rate' must be a whole number from 1 to 1000000"},
        BadCase{"program = \"p.c\"\nrate = 1.5\n",
                "s.toml:2:8: 'rate' must be a whole number from 1 to 1000000"},
        BadCase{"program = \"p.c\"\ncycle_us = 300\n",
                "s.toml:2:12: 'cycle_us' must be a multiple of 125"},
        BadCase{"program = \"p.c\"\ndouble = \"8.8\"\n",
                "s.toml:2:10: 'double' is '8.8': expected \"32.16\" or \"16.16\""},
        BadCase{"program = \"p.c\"\nuntil_ms = -1\n",
                "s.toml:2:12: 'until_ms' must be a time in ms, from 0 to 1000000000"},
        BadCase{"program = \"p.c\"\nexplore = \"maybe\"\n",
                "s.toml:2:11: 'explore' must be \"prove\", or a table as in { engine = "
                "\"stateful\", verdict = \"FAILED\" }"},
        BadCase{"program = \"p.c\"\nexplore = { engin = \"dpor\" }\n",
                "s.toml:2:13: unknown key 'engin'; did you mean 'engine'?"},
        BadCase{"program = \"p.c\"\nexpect = \"x == 1\"\n",
                "s.toml:2:10: 'expect' must be a list of strings, as in [\"sum == 5050\"]"},
        BadCase{"program = \"p.c\"\nglobals = 3\n",
                "s.toml:2:11: 'globals' must be a table, as in [globals]"},
        BadCase{"program = \"p.c\"\n[globals]\nx = \"1\"\n",
                "s.toml:3:1: 'x' must be a number or a list of numbers"},
        BadCase{"program = \"p.c\"\n[thread]\nfunction = \"f\"\n",
                "s.toml:2:1: 'thread' must be a list of tables, each under [[thread]]"},
        BadCase{"program = \"p.c\"\n[world.input]\nvalue = 1\n",
                "s.toml:2:1: 'input' must be a list of tables, each under [[world.input]]"},
        BadCase{"program = \"p.c\"\n[ethercat.slave]\n",
                "s.toml:2:1: 'slave' must be a list of tables, each under [[ethercat.slave]]"},
        BadCase{"program = \"p.c\"\n[[thread]]\nfunction = \"f\"\nexpect = [\"n == 1\"]\n",
                "s.toml:4:1: 'expect' is a key of the whole file: move it above the first table"},
        BadCase{"program = \"p.c\"\n[[world.input]]\nvalue = 1\nrate = 9\n",
                "s.toml:4:1: 'rate' is a key of the whole file: move it above the first table"},
        BadCase{"program = \"p.c\"\n[globals]\nn = 1\nexpect = [\"n == 1\"]\n",
                "s.toml:4:1: 'expect' is a key of the whole file: move it above the first table"},
        BadCase{"program = \"p.c\"\nexplore = { limit_ms = 5 }\n",
                "s.toml:2:13: 'limit_ms' is a key of the whole file: move it out of this table"},
        BadCase{"program = \"p.c\"\nhost = 5\n",
                "s.toml:2:8: 'host' must be a list of tables, each under [[host]]"},
        BadCase{"host = {}\n",
                "s.toml:1:8: 'host' must name either a 'source', as in { source = \"host.c\" }, or "
                "a 'command', as in { command = [\"./host\"] }"},
        BadCase{"host = { source = \"h.c\", command = [\"./h\"] }\n",
                "s.toml:1:8: 'host' must name either a 'source', as in { source = \"host.c\" }, or "
                "a 'command', as in { command = [\"./host\"] }"},
        BadCase{"host = { command = [\"./h\"], flags = [\"-O2\"] }\n",
                "s.toml:1:37: 'flags' is only for a 'source': write it into 'command', or remove "
                "it"},
        BadCase{"host = { command = [\"./h\"], arguments = [\"1\"] }\n",
                "s.toml:1:41: 'arguments' is only for a 'source': write it into 'command', or "
                "remove it"},
        BadCase{"host = { source = \"h.c\", flag = [\"-O2\"] }\n",
                "s.toml:1:26: unknown key 'flag'; did you mean 'flags'?"}));

TEST(ParseScenario, AsksNothingOfTheEndOfAnEndlessProgram) {
  EXPECT_TRUE(Parse("program = \"p.c\"\nendless = true\nnever = [\"x == 1\"]\n"
                    "expect = [\"x == 0 @ 2ms\"]\n")
                  .endless);
  const std::string endless = "program = \"p.c\"\nendless = true\n";
  EXPECT_EQ(ErrorOf(endless + "final = [\"x == 1\"]\n"),
            "s.toml:3:10: 'final: x == 1' is about the end of runs, and an endless program has "
            "none: use 'always' or 'never', or remove 'endless'");
  EXPECT_THAT(ErrorOf(endless + "eventually = [\"x == 1\"]\n"),
              StartsWith("s.toml:3:15: 'eventually: x == 1' is about the end of runs"));
  EXPECT_EQ(ErrorOf(endless + "expect = [\"x == 1\"]\n"),
            "s.toml:3:11: 'x == 1' is expected at the end of the run, and an endless program has "
            "none: add an instant, as in '@ 100ms', or remove 'endless'");
}

TEST(ParseScenario, ReadsTheHostProgram) {
  const Scenario built =
      Parse("host = { source = \"h.c\", flags = [\"-I..\"], arguments = [\"1\", \"2\"] }\n");
  EXPECT_EQ(built.host_program, (HostProgram{"h.c", {"-I.."}, {"1", "2"}, {}}));
  EXPECT_EQ(built.program, "");
  const Scenario ready = Parse("[host]\ncommand = [\"./h\", \"1\"]\n");
  EXPECT_EQ(ready.host_program, (HostProgram{"", {}, {}, {"./h", "1"}}));
  for (const Scenario& scenario : {built, ready}) {
    EXPECT_EQ(Parse(FormatScenario(scenario)).host_program, scenario.host_program);
    EXPECT_THAT(scenario.host, testing::IsEmpty());
  }
}

TEST(ParseScenario, GivesAHostProgramOnlyToThoseWhoRunOne) {
  const std::string text = "host = { source = \"h.c\" }\nexpect = [\"gpo == 0\"]\n";
  for (const ScenarioUse use : {ScenarioUse::kRun, ScenarioUse::kSession, ScenarioUse::kExplore}) {
    EXPECT_EQ(ErrorsOf(text, use).substr(0, 45), "s.toml:1:1: 'host' names a host program, whic");
  }
  EXPECT_EQ(ErrorsOf(text, ScenarioUse::kTest), "no error");
  EXPECT_EQ(ErrorsOf(text, ScenarioUse::kHost), "no error");
  EXPECT_THAT(ErrorsOf("program = \"p.c\"\n" + text, ScenarioUse::kTest),
              StartsWith("s.toml:1:1: 'program' cannot be used with a host program"));
  EXPECT_THAT(ErrorsOf("[[host]]\nset = { n = 1 }\n", ScenarioUse::kHost),
              StartsWith("s.toml:1:3: 'host' cannot be used with a host program"));
}

TEST(ParseScenario, ShowsEverythingThatIsWrongInItsPlace) {
  EXPECT_THAT(ErrorsOf("rat = 5\ntitle = \"轴\"; \nrate = 0\n"),
              StartsWith("s.toml:2:12: not TOML"));
  EXPECT_THAT(ErrorsOf("expect = [\"x == 1\", \"x =\", 5]\nrate = 0 # 轴\nrat = 5\n"
                       "globals = { 轴 = 1 }\n"),
              StartsWith("s.toml:4:13: non-ASCII characters are allowed only in strings"));
  EXPECT_EQ(ErrorsOf("program = \"轴.c\"\nexpect = [\"轴 == 1\", 5]\nrate = 0\nrat = 5\n"),
            "s.toml:2:11: '轴' is not expected in '轴 == 1'\n"
            "    2 | expect = [\"轴 == 1\", 5]\n"
            "      |           ^~~~~~~~~\n"
            "s.toml:2:21: an expectation must be a string\n"
            "    2 | expect = [\"轴 == 1\", 5]\n"
            "      |                      ^\n"
            "s.toml:3:8: 'rate' must be a whole number from 1 to 1000000\n"
            "    3 | rate = 0\n"
            "      |        ^\n"
            "s.toml:4:1: unknown key 'rat'; did you mean 'rate'?\n"
            "    4 | rat = 5\n"
            "      | ^~~");
}

TEST(ParseScenario, ShowsSoManyErrorsAndCountsTheRest) {
  std::string text = "program = \"p.c\"\n";
  for (int i = 0; i < 23; ++i) text += "key" + std::to_string(i) + " = 1\n";
  const std::string errors = ErrorsOf(text);
  EXPECT_EQ(errors.substr(errors.rfind('\n') + 1), "3 more errors");
}

TEST(ParseScenario, RefusesAPriorityThatNothingUses) {
  EXPECT_THAT(ErrorOf("program = \"p.c\"\n[[thread]]\nfunction = \"f\"\npriority = 1\n"),
              StartsWith("s.toml:4:12: 'priority' is only for periodic threads"));
}

TEST(ParseScenario, RefusesWhatACommandCannotUse) {
  const std::string races = "program = \"p.c\"\nraces = \"none\"\n";
  EXPECT_THAT(ErrorsOf(races, ScenarioUse::kRun),
              StartsWith("s.toml:2:1: 'races' concerns all schedules"));
  EXPECT_EQ(ErrorsOf(races, ScenarioUse::kTest), ErrorsOf(races, ScenarioUse::kRun));
  EXPECT_EQ(ErrorsOf(races + "explore = \"prove\"\n", ScenarioUse::kTest), "no error");
  EXPECT_EQ(ErrorsOf(races, ScenarioUse::kExplore), "no error");
  EXPECT_EQ(ErrorsOf(races, ScenarioUse::kSession), "no error");
  EXPECT_EQ(ErrorsOf("expect = []\n", ScenarioUse::kHost), "no error");
  EXPECT_THAT(ErrorsOf("sync = []\n", ScenarioUse::kHost),
              StartsWith("s.toml:1:1: 'sync' cannot be used with a host program"));
}

// A host may run for long before there is a program to read them for.
TEST(ParseScenario, ReadsTheRequirementsOfAHostAtOnce) {
  EXPECT_EQ(ErrorsOf("always = [\"x < 3\"]\nfinal = [\"y == 1\"]\n", ScenarioUse::kHost),
            "no error");
  EXPECT_THAT(ErrorsOf("always = [\"x < 3\", \"x <\"]\n", ScenarioUse::kHost),
              StartsWith("s.toml:1:20: "));
}

struct UnusedSetting {
  const char* wishes;
  const char* error;
};

class UnusedSettings : public testing::TestWithParam<UnusedSetting> {};

TEST_P(UnusedSettings, AreRefusedWhereTheyStand) {
  const std::string text =
      std::string("program = \"p.c\"\nexplore = { ") + GetParam().wishes + " }\n";
  for (const ScenarioUse use : {ScenarioUse::kTest, ScenarioUse::kExplore}) {
    const std::string errors = ErrorsOf(text, use);
    EXPECT_EQ(errors.substr(0, errors.find('\n')), GetParam().error);
  }
}

INSTANTIATE_TEST_SUITE_P(
    ScenarioParse, UnusedSettings,
    testing::Values(
        UnusedSetting{"max_states = 9", "no error"},
        UnusedSetting{"max_executions = 9", "no error"},
        UnusedSetting{"engine = \"pct\", runs = 9", "no error"},
        UnusedSetting{"engine = \"dpor\", max_states = 9",
                      "s.toml:2:43: 'max_states' has no effect with the engine dpor: remove it, or "
                      "use auto, stateful, bounded"},
        UnusedSetting{"engine = \"stateful\", max_executions = 9",
                      "s.toml:2:51: 'max_executions' has no effect with the engine stateful: "
                      "remove it, or use auto, dpor"},
        UnusedSetting{"runs = 9",
                      "s.toml:2:20: 'runs' has no effect with the engine auto: remove it, or use "
                      "random, pct, pos"},
        UnusedSetting{
            "follow = \"x\", runs = 9",
            "s.toml:2:34: 'runs' has no effect if only one schedule is followed: remove it"},
        UnusedSetting{
            "follow = \"x\", engine = \"dpor\"",
            "s.toml:2:36: 'engine' has no effect if only one schedule is followed: remove it"}));

TEST(ParseScenario, SaysWhatIsMissing) {
  EXPECT_THAT(ErrorOf("rate = 5\n"), HasSubstr("'program' is missing"));
  EXPECT_THAT(ErrorOf("card = \"GE-800-PG\"\n"),
              HasSubstr("the card GE-800-PG executes no motion programs, only the calls of a host: "
                        "name it in 'host', or run it with 'oncard exec --scenario'"));
  EXPECT_THAT(ErrorOf("program = \"p.c\"\n[[thread]]\npage = 1\n"),
              HasSubstr("'function' is missing"));
  EXPECT_THAT(ErrorOf("program = \"p.c\"\n[[world.input]]\nat_ms = 1\n"),
              HasSubstr("'value' is missing"));
}

TEST(ParseScenario, BindsAThreadOnce) {
  EXPECT_THAT(
      ErrorOf("program = \"p.c\"\n[[thread]]\nfunction = \"f\"\n[[thread]]\nfunction = \"g\"\n"),
      HasSubstr("thread 0 is bound twice"));
}

TEST(ParseScenario, ReportsTomlMistakesWithTheirPlace) {
  EXPECT_THAT(ErrorOf("program = \"p.c\"\nrate = = 5\n"), StartsWith("s.toml:2:"));
}

TEST(ParseScenario, NamesTheInputsThereAre) {
  EXPECT_THAT(ErrorOf("program = \"p.c\"\n[[world.input]]\ntype = \"gpio\"\nvalue = 1\n"),
              HasSubstr("limit_positive"));
}

TEST(ParseThreadStart, ReadsTheShortForm) {
  EXPECT_EQ(ParseThreadStart("0=add").value(), (ThreadStart{0, "add", 0, {}, 0, 4}));
  EXPECT_EQ(ParseThreadStart("7=add@3").value(), (ThreadStart{7, "add", 3, {}, 0, 4}));
  EXPECT_EQ(ParseThreadStart("7=add:a=1,b[2]=-2.5").value(),
            (ThreadStart{7, "add", 7, {{"a", {1}}, {"b[2]", {-2.5}}}, 0, 4}));
  for (const char* text : {"", "add", "0=", "32=add", "-1=add", "0=add@32", "0=add@",
                           "0=add:", "0=add:x", "0=add:x=y", "0=:x=1"}) {
    EXPECT_FALSE(ParseThreadStart(text).ok()) << text;
  }
}

TEST(ParseThreadStart, SaysWhichNumbersThereAre) {
  EXPECT_EQ(ParseThreadStart("32=add").error().message.en,
            "thread 32 in '32=add': it must be from 0 to 31");
  EXPECT_EQ(ParseThreadStart("-1=add").error().message.zh, "“-1=add”中的线程 -1：应为 0 至 31");
  EXPECT_EQ(ParseThreadStart("0=add@32").error().message.en,
            "page 32 in '0=add@32': it must be from 0 to 31");
  EXPECT_THAT(ParseThreadStart("x=add").error().message.en, StartsWith("'x=add' is not a thread"));
}

TEST(MoveScenario, KeepsTheFilesReachable) {
  Scenario s;
  s.path = "a/b/s.toml";
  s.program = "../p.c";
  s.include_folders = {"inc"};
  s.host_program = {{"../h.c", {}, {}, {}}};
  const Scenario moved = MoveScenario(s, "a/out/x.schedule");
  EXPECT_EQ(moved.program, "../p.c");
  EXPECT_EQ(moved.include_folders, std::vector<std::string>{"../b/inc"});
  EXPECT_EQ(ProgramPath(moved), "a/p.c");
  EXPECT_EQ(moved.host_program->source, "../h.c");
}

}  // namespace
}  // namespace oncard::runtime
