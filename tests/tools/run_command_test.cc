// The commands run and replay: results, exit codes, recordings, traces.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;

using Json = nlohmann::json;

const std::string kCounter = kSamples + "/07_shared_global/counter.c";

TEST(Run, PrintsThreadsAndValues) {
  const ProcessResult result =
      RunOncard({"run", kSum, "--thread", "0=add:begin=1,end=100", "--show", "sum"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, "thread 0 add: finished, result 5050\nsum = 5050\n");
}

TEST(Run, SpeaksChinese) {
  const ProcessResult result =
      RunOncard({"--lang=zh", "run", kSum, "--thread", "0=add:begin=1,end=100"});
  EXPECT_EQ(result.out, "线程 0 add：已结束，返回值 5050\nsum = 5050\n");
}

TEST(Run, LogsRefusedCommands) {
  const ScratchFolder scratch;
  scratch.Write("p.c", "int f()\n{\n  GT_AxisOn(9);\n  return 0;\n}\n");
  const ProcessResult result =
      RunOncard({"run", "p.c"}, scratch.path(), {"ONCARD_LOG=calls:log.txt"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(scratch.Read("log.txt"),
            "0.250 card0 thread 0: GT_AxisOn(9) = 7: parameter axis is 9; this card has 1 to 8\n");
}

TEST(Run, BindsTheFirstFunctionByDefault) {
  const ScratchFolder scratch;
  const std::string first =
      scratch.Write("p.c", "int one()\n{\n  return 1;\n}\nint two()\n{\n  return 2;\n}\n");
  EXPECT_EQ(RunOncard({"run", first}).out, "thread 0 one: finished, result 1\n");
  const std::string named =
      scratch.Write("q.c", "int one()\n{\n  return 1;\n}\nint main()\n{\n  return 2;\n}\n");
  EXPECT_EQ(RunOncard({"run", named}).out, "thread 0 main: finished, result 2\n");
}

TEST(Run, WritesNothingBesideTheSource) {
  const ScratchFolder scratch;
  RunOncard({"run", scratch.Write("p.c", "int f()\n{\n  return 1;\n}\n")});
  EXPECT_FALSE(scratch.Has("p.bin"));
  EXPECT_FALSE(scratch.Has("p.ini"));
}

TEST(Run, LoadsObjects) {
  const ScratchFolder scratch;
  RunOncard({"build", "-o", scratch.path(), kSum});
  const ProcessResult result = RunOncard({"run", scratch.path() + "/sum.bin", "--thread",
                                          "5=add@9:begin=2,end=3", "--show", "page9.i"});
  EXPECT_EQ(result.out, "thread 5 add: finished, result 5\npage9.i = 4\n");
}

TEST(Run, SetsGlobalsAndShowsArrays) {
  const ProcessResult result =
      RunOncard({"run", kSamples + "/05_arrays/largest.c", "--set", "value=1,2,9,3"});
  EXPECT_EQ(result.out, "thread 0 largest: finished, result 2\nvalue = [1, 2, 9, 3, 0, 0, 0, 0]\n");
}

TEST(Run, ReportsAFaultWithItsPlaceAndValues) {
  const ProcessResult result =
      RunOncard({"run", "largest.c", "--thread", "0=pick:i=8", "--show", "thread0.error"},
                kSamples + "/05_arrays");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(
      result.out,
      "thread 0 pick: fault at largest.c:35: index 8 is out of bounds: the array has elements "
      "0 to 7\nthread0.error = 101\n");
  EXPECT_THAT(result.err, HasSubstr("largest.c:35"));
}

TEST(Run, ReportsADivisionByZero) {
  const ScratchFolder scratch;
  scratch.Write("p.c", "int f(int n)\n{\n  n = 7 / n;\n  return n;\n}\n");
  const ProcessResult result = RunOncard({"run", "p.c"}, scratch.path());
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "thread 0 f: fault at p.c:3: division by zero\n");
}

TEST(Run, ReportsADeadlock) {
  const ScratchFolder scratch;
  const std::string source =
      scratch.Write("p.c", "int go;\nint f()\n{\n  GT_WaitForVarEq(&go, 1);\n  return 1;\n}\n");
  const ProcessResult result = RunOncard({"run", source, "--format=json"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(Json::parse(result.out)["end"], "deadlock");
  EXPECT_THAT(result.err, HasSubstr("deadlock"));
}

TEST(Run, FailsAtTheTimeLimitButNotAtTheEndAskedFor) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", "int f()\n{\nlbl:\n  goto lbl;\n}\n");
  EXPECT_EQ(RunOncard({"run", source, "--limit=5"}).exit_code, 1);
  const ProcessResult until = RunOncard({"run", source, "--until=2.5", "--format=json"});
  EXPECT_EQ(until.exit_code, 0) << until.err;
  const Json json = Json::parse(until.out);
  EXPECT_EQ(json["end"], "until");
  EXPECT_EQ(json["time_ms"], 2.5);
  // 100 statements per ms.
  EXPECT_EQ(json["statements"], 250);
}

TEST(Run, RateAndCycleDecideHowMuchATimeHolds) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", "int f()\n{\nlbl:\n  goto lbl;\n}\n");
  const ProcessResult result =
      RunOncard({"run", source, "--until=10", "--rate=10", "--cycle=1000", "--format=json"});
  EXPECT_EQ(Json::parse(result.out)["statements"], 100);
}

TEST(Run, ChecksExpectations) {
  EXPECT_EQ(RunOncard({"run", kSum, "--thread", "0=add:begin=1,end=9", "--expect", "sum == 45"})
                .exit_code,
            0);
  const ProcessResult wrong =
      RunOncard({"run", kSum, "--thread", "0=add:begin=1,end=9", "--expect", "sum == 46"});
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_EQ(wrong.err, "oncard: sum == 46: sum is 45\n");
}

TEST(Run, RunsScenarios) {
  const ProcessResult result =
      RunOncard({"run", kSamples + "/04_switch/case_5.toml", "--show", "gpo"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "thread 0 choose: finished, result 0\ngpo = 4\n");
}

TEST(Run, LooksAtWhatCommentsOfASourceRequire) {
  const ScratchFolder scratch;
  const std::string body =
      "int x, y;\nint t0()\n{\n  x = y;\n  return x;\n}\nint t1()\n{\n  y = 2;\n  return y;\n}\n";
  scratch.Write("good.c", "//@ init: y = 1\n//@ always: x < 3\n" + body);
  scratch.Write("bad.c", "//@ init: y = 1\n//@ never: x == 1\n" + body);
  scratch.Write("races.c", "//@ init: y = 1\n  //@ races: none\n" + body + "//@ sync: x, y\n");
  scratch.Write("wrong.c", "//@ finally: x == 1\n//@ nevr: x == 1\n" + body);
  scratch.Write("s.toml", "program = \"bad.c\"\n[[thread]]\nfunction = \"t1\"\n");
  const auto run = [&](const char* file) { return RunOncard({"run", file}, scratch.path()); };
  // With the round robin thread 0 is the first.
  EXPECT_EQ(run("good.c").out,
            "thread 0 t0: finished, result 1\nthread 1 t1: finished, result 2\nx = 1\ny = 2\n");
  const ProcessResult bad = run("bad.c");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_EQ(
      bad.err,
      "oncard: never: x == 1: holds after thread 0 has executed bad.c:6, at 0.25 ms: x is 1\n");
  const ProcessResult races = run("races.c");
  EXPECT_EQ(races.exit_code, 2);
  const std::string refusal =
      " concerns all schedules, a single run cannot check it: use 'oncard explore', or remove it\n";
  EXPECT_EQ(races.err, "oncard: races.c:2:3: '//@ races'" + refusal +
                           "    2 |   //@ races: none\n      |   ^~~~~~~~~~~~~~~\n"
                           "races.c:14:1: '//@ sync'" +
                           refusal + "   14 | //@ sync: x, y\n      | ^~~~~~~~~~~~~~\n");
  const ProcessResult wrong = run("wrong.c");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("wrong.c:1:1: "));
  EXPECT_THAT(wrong.err, HasSubstr("wrong.c:2:1: "));
  EXPECT_THAT(wrong.err, HasSubstr("\n    2 | //@ nevr: x == 1\n      | ^~~~~~~~~~~~~~~~\n"));
  EXPECT_EQ(run("s.toml").err,
            "oncard: warning: bad.c:1: this comment is not checked: the requirements come from the "
            "scenario; write it there\n");
}

// All errors, each with its place, whichever command reads them: the explorer's models with and
// without a card, and a single run.
TEST(Run, ShowsRequirementsThatCannotBeReadInTheirPlaces) {
  const ScratchFolder scratch;
  const std::string body = "int t0()\n{\n  n = 1;\n  GT_Delay(1);\n  return n;\n}\n";
  scratch.Write("p.c", "int n;\n" + body);
  scratch.Write("s.toml",
                "program = \"p.c\"\nfinal = [\"n == 1\", \"(\"]\nalways = [\n  \"n <\",\n]\n"
                "never = [\"m == 1\"]\n[[thread]]\nfunction = \"t0\"\n");
  const std::string comments = "int n;\n//@ final: n ==\n  //@ never:  m == 1\n";
  scratch.Write("card.c", comments + body);
  scratch.Write("plain.c", comments + "int t0()\n{\n  return n;\n}\n");
  struct Case {
    const char* file;
    std::vector<std::string> wanted;
  };
  const Case cases[] = {
      {"s.toml",
       {"s.toml:2:20: a variable or a number is missing in '('\n    2 | final = [\"n == 1\", "
        "\"(\"]\n"
        "      |                    ^~~\n",
        "s.toml:4:3: a variable or a number is missing in 'n <'\n", "s.toml:6:10: "}},
      {"card.c",
       {"card.c:2:12: ", "    2 | //@ final: n ==\n      |            ^~~~\n", "card.c:3:15: "}},
      {"plain.c", {"plain.c:2:12: ", "plain.c:3:15: "}},
  };
  for (const char* command : {"run", "explore", "test"}) {
    for (const Case& test : cases) {
      if (std::string(command) == "test" && std::string(test.file) != "s.toml") continue;
      const ProcessResult result = RunOncard({command, test.file}, scratch.path());
      EXPECT_NE(result.exit_code, 0);
      const std::string said = result.out + result.err + '\n';
      for (const std::string& wanted : test.wanted) {
        EXPECT_THAT(said, HasSubstr(wanted)) << command << ' ' << wanted << '\n' << said;
      }
    }
  }
}

TEST(Run, WarnsOfRefusedCommandsOrFailsByThem) {
  const ScratchFolder scratch;
  scratch.Write("p.c", "int f()\n{\n  GT_AxisOn(9);\n  GT_AxisOn(1);\n  return 0;\n}\n");
  scratch.Write("s.toml", "program = \"p.c\"\n");
  const ProcessResult run = RunOncard({"run", "p.c"}, scratch.path());
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err.rfind("oncard: warning: p.c:3: thread 0 f: GT_AxisOn(9) = 7: ", 0), 0u)
      << run.err;
  const ProcessResult strict = RunOncard({"run", "--strict-commands", "p.c"}, scratch.path());
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_EQ(strict.err.rfind("oncard: p.c:3: thread 0 f: GT_AxisOn(9) = 7: ", 0), 0u) << strict.err;
  const ProcessResult test = RunOncard({"test", "s.toml"}, scratch.path());
  EXPECT_EQ(test.exit_code, 0);
  EXPECT_THAT(test.out, HasSubstr("     warning: p.c:3: thread 0 f: GT_AxisOn(9) = 7: "));
  EXPECT_EQ(RunOncard({"test", "--strict-commands", "s.toml"}, scratch.path()).exit_code, 1);
  const ProcessResult explored = RunOncard({"explore", "s.toml"}, scratch.path());
  EXPECT_EQ(explored.exit_code, 0);
  EXPECT_EQ(explored.err.rfind("oncard: warning: p.c:3: thread 0 f: GT_AxisOn(9) = 7: ", 0), 0u)
      << explored.err;
  EXPECT_EQ(RunOncard({"explore", "--strict-commands", "s.toml"}, scratch.path()).exit_code, 1);
}

TEST(Run, WarnsOfWhatCannotBeMeantOrFailsByIt) {
  const ScratchFolder scratch;
  scratch.Write("p.c",
                "int f()\n{\n  GT_AxisOn(1);\n  GT_PrfTrap(1);\n  GT_SetPos(1, 100);\n"
                "  GT_Update(1);\n  return 0;\n}\n");
  scratch.Write("s.toml", "program = \"p.c\"\n");
  const std::string place = "p.c:6: thread 0 f: axis 1 is started without a velocity";
  const auto run = [&](const std::vector<std::string>& arguments) {
    return RunOncard(arguments, scratch.path());
  };
  EXPECT_THAT(run({"run", "p.c"}).err, HasSubstr("oncard: warning: " + place));
  EXPECT_THAT(run({"test", "s.toml"}).out, HasSubstr("     warning: " + place));
  EXPECT_THAT(run({"explore", "s.toml"}).err, HasSubstr("oncard: warning: " + place));
  for (const std::string command : {"run", "test", "explore"}) {
    EXPECT_EQ(run({command, "s.toml"}).exit_code, 0) << command;
    EXPECT_EQ(run({command, "--strict-commands", "s.toml"}).exit_code, 1) << command;
    const ProcessResult silent = run({command, "--strict-commands", "-Wno-no-velocity", "s.toml"});
    EXPECT_EQ(silent.exit_code, 0) << command << silent.err;
    EXPECT_EQ(run({command, "-Wno-such", "s.toml"}).exit_code, 2) << command;
  }
  const Json report = Json::parse(run({"run", "--format=json", "s.toml"}).out);
  EXPECT_THAT(report["warnings"][0].get<std::string>(), HasSubstr("[no-velocity]"));
}

TEST(Run, ExitCodesTellWhatWentWrong) {
  const ScratchFolder scratch;
  EXPECT_EQ(RunOncard({"run", "/nonexistent.c"}).exit_code, 3);
  EXPECT_EQ(RunOncard({"run", "/nonexistent.toml"}).exit_code, 3);
  EXPECT_EQ(RunOncard({"run", scratch.Write("s.toml", "programm = \"x.c\"\n")}).exit_code, 3);
  EXPECT_EQ(RunOncard({"run", scratch.Write("bad.c", "int f( {\n")}).exit_code, 1);
  EXPECT_EQ(RunOncard({"run", kSum, "--thread", "add"}).exit_code, 2);
  EXPECT_EQ(RunOncard({"run", kSum, "--thread", "32=add"}).exit_code, 2);
  EXPECT_EQ(RunOncard({"run", kSum, "--thread", "0=sub"}).exit_code, 2);
  EXPECT_EQ(RunOncard({"run", kSum, "--show", "summ"}).exit_code, 2);
  EXPECT_EQ(RunOncard({"run", kSum, "--schedule", "fifo"}).exit_code, 2);
  EXPECT_EQ(RunOncard({"run", kSum, "--record", "/nonexistent/x"}).exit_code, 3);
}

TEST(Run, SuggestsTheNearestName) {
  EXPECT_THAT(RunOncard({"run", kSum, "--thread", "0=ad"}).err, HasSubstr("'add'"));
  EXPECT_THAT(RunOncard({"run", kSum, "--show", "summ"}).err, HasSubstr("'sum'"));
}

TEST(Run, WritesTracesInThreeForms) {
  const ScratchFolder scratch;
  const std::vector<std::string> base = {
      "run", kSamples + "/09_blink/blink.c", "--thread", "0=blink:times=1", "--show", "page0.i"};
  const auto trace = [&](const std::string& name) {
    std::vector<std::string> arguments = base;
    arguments.insert(arguments.end(), {"--trace", scratch.path() + "/" + name});
    EXPECT_EQ(RunOncard(arguments).exit_code, 0);
    return scratch.Read(name);
  };
  // On in the first cycle, off 40 cycles later, the end another 40 cycles later.
  EXPECT_EQ(trace("t.csv"), "time_ms,page0.i,gpo\n0,0,0\n0.25,0,1\n10.25,0,0\n20.25,1,0\n");
  const Json events = Json::parse(trace("t.json"))["traceEvents"];
  const Json lamp_off =
      Json::parse(R"({"name":"gpo","ph":"C","pid":1,"ts":10250,"args":{"value":0}})");
  EXPECT_NE(std::find(events.begin(), events.end(), lamp_off), events.end()) << events.dump(2);
  const std::string vcd = trace("t.vcd");
  EXPECT_THAT(vcd, HasSubstr("$timescale 1 us $end"));
  EXPECT_THAT(vcd, HasSubstr("#10250\nb00000000000000000000000000000000 \"\n"));
}

class RecordTest : public testing::TestWithParam<const char*> {};

// Four threads that affect each other: any other order gives other values.
TEST_P(RecordTest, ReplayGivesTheSameRun) {
  const ScratchFolder scratch;
  const std::string file = scratch.path() + "/run.schedule";
  const ProcessResult run = RunOncard(
      {"run", kCounter, "--thread", "0=count_in_three:n=700", "--thread", "1=count_in_three:n=500",
       "--thread", "2=count_in_one:n=900", "--thread", "7=count_in_three:n=800", "--schedule",
       GetParam(), "--record", file, "--format=json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const ProcessResult replay = RunOncard({"replay", file, "--format=json"});
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  const Json first = Json::parse(run.out);
  const Json second = Json::parse(replay.out);
  EXPECT_EQ(first["state_hash"], second["state_hash"]);
  EXPECT_EQ(first["values"], second["values"]);
  EXPECT_EQ(first["statements"], second["statements"]);
  // Checkpoints every 10 000 statements, and one at the end.
  EXPECT_THAT(scratch.Read("run.schedule"), HasSubstr("\ncheck 10000 "));
}

INSTANTIATE_TEST_SUITE_P(Policies, RecordTest,
                         testing::Values("rr", "rr:7", "priority", "random:1", "random:99",
                                         "pct:5:3"));

TEST(Record, TwoRunsGiveTheSameBytes) {
  const ScratchFolder scratch;
  for (const char* name : {"a", "b"}) {
    RunOncard({"run", kCounter, "--schedule=random:3", "--thread", "0=count_in_three:n=50",
               "--thread", "1=count_in_three:n=50", "--record", scratch.path() + "/" + name});
  }
  EXPECT_NE(scratch.Read("a"), "");
  EXPECT_EQ(scratch.Read("a"), scratch.Read("b"));
}

class ReplayTest : public testing::Test {
 protected:
  void SetUp() override {
    scratch_.Write("p.c", kProgram);
    const ProcessResult run = RunOncard(
        {"run", "p.c", "--thread", "0=f:n=3", "--thread", "1=f:n=4", "--record", "run.schedule"},
        scratch_.path());
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  ProcessResult Replay() { return RunOncard({"replay", "run.schedule"}, scratch_.path()); }
  void Edit(const std::string& name, const std::string& from, const std::string& to) {
    std::string text = scratch_.Read(name);
    const size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos) << text;
    scratch_.Write(name, text.replace(place, from.size(), to));
  }

  static constexpr const char* kProgram =
      "int sum;\nint f(int n)\n{\n  int cc;\nlbl:\n  sum = sum + n;\n  n = n - 1;\n  cc = n > 0;\n"
      "  if (cc) goto lbl;\n  return sum;\n}\n";
  ScratchFolder scratch_;
};

TEST_F(ReplayTest, StandsAloneBesideItsProgram) {
  const ProcessResult result = Replay();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("sum = 16\n"));
}

TEST_F(ReplayTest, RefusesAnotherProgramAndShowsBothHashes) {
  Edit("p.c", "n - 1", "n - 2");
  const ProcessResult result = Replay();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("another program"));
}

TEST_F(ReplayTest, AllowsOtherNamesAndLines) {
  Edit("p.c", "int sum;", "int sum;\n\n\n");
  EXPECT_EQ(Replay().exit_code, 0);
}

TEST_F(ReplayTest, SaysWhereItLeavesTheRecordedRun) {
  Edit("run.schedule", "\"n\" = 3", "\"n\" = 2");
  const ProcessResult result = Replay();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("statement"));
}

TEST_F(ReplayTest, RefusesADamagedFile) {
  Edit("run.schedule", "end ", "and ");
  EXPECT_EQ(Replay().exit_code, 3);
  scratch_.Write("run.schedule", "something else\n");
  EXPECT_EQ(Replay().exit_code, 3);
}

constexpr const char* kCountToThree =
    "int n;\nint f()\n{\n  int cc;\nlbl:\n  n = n + 1;\n  cc = n < 3;\n  if (cc) goto lbl;\n"
    "  return n;\n}\n";

TEST(RunSteps, ShowsWhatEveryStatementDoes) {
  const ScratchFolder scratch;
  const std::string program = scratch.Write("p.c", kCountToThree);
  const std::string table =
      "        thread 0 f\n"
      "0.25 ms\n"
      "     1     6  n = n + 1;   [n = 0]   n: 0 -> 1\n"
      "     2     7  cc = n < 3;   [n = 1]   cc: 0 -> 1\n"
      "     3     8  if (cc) goto lbl;   [cc = 1]\n"
      "   ...        lines 6–8 × 2 more   n: 1 -> 3, cc: 1 -> 0\n"
      "    10     9  return n;   [n = 3]\n"
      "\n";
  const std::string results = "thread 0 f: finished, result 3\nn = 3\n";
  EXPECT_EQ(RunOncard({"run", program, "--steps"}).out, table + results);
  EXPECT_EQ(RunOncard({"run", program}).out, results);
  const ProcessResult full = RunOncard({"run", program, "--steps", "--full"});
  EXPECT_THAT(full.out, HasSubstr("     7     6  n = n + 1;   [n = 2]   n: 2 -> 3\n"));
  const ProcessResult narrow = RunOncard({"run", program, "--steps"}, {}, {"COLUMNS=40"});
  EXPECT_THAT(narrow.out, HasSubstr("     1     6  n = n + 1;   [n = 0]\n"
                                    "                n: 0 -> 1\n"));
}

TEST(RunSteps, AreInJson) {
  const ScratchFolder scratch;
  const std::string program = scratch.Write("p.c", kCountToThree);
  const auto json =
      nlohmann::json::parse(RunOncard({"run", program, "--steps", "--format=json"}).out);
  ASSERT_EQ(json["steps"].size(), 10u);
  EXPECT_EQ(json["steps"][3]["line"], 6);
  EXPECT_EQ(json["steps"][3]["reads"]["n"], 1);
  EXPECT_EQ(json["steps"][3]["writes"]["n"], (nlohmann::json{1, 2}));
}

TEST(RunSteps, WhatTheCardDoesByItselfStandsBelow) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kCountToThree);
  scratch.Write("p.toml",
                "program = \"p.c\"\nuntil_ms = 1\n[[world.input]]\ntype = \"alarm\"\nindex = 2\n"
                "value = 1\n");
  const ProcessResult shown = RunOncard({"run", "p.toml", "--steps"}, scratch.path());
  EXPECT_THAT(shown.out,
              HasSubstr("what the card did by itself:\n0 ms  the drive of axis 2 reports an "
                        "alarm at 0: it is switched off\n"));
}

TEST(RunSteps, AReplayShowsTheSame) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kCountToThree);
  const auto run = [&](std::vector<std::string> arguments) {
    return RunOncard(arguments, scratch.path());
  };
  const ProcessResult recorded =
      run({"run", "p.c", "--steps", "--record=r.schedule", "--trace=a.csv"});
  const ProcessResult replayed = run({"replay", "r.schedule", "--steps", "--trace=b.csv"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_EQ(replayed.out, recorded.out);
  EXPECT_NE(scratch.Read("a.csv"), "");
  EXPECT_EQ(scratch.Read("b.csv"), scratch.Read("a.csv"));
}

// --- Choices -------------------------------------------------------------------------------------

constexpr const char* kOpen =
    "int n;\n//@ input: n = 3..9\n//@ always: n >= 3\nint t0()\n{\n  return n;\n}\n";

TEST(RunChoices, TheSmallestIsTakenAndSaid) {
  const ScratchFolder scratch;
  const std::string program = scratch.Write("p.c", kOpen);
  const ProcessResult run = RunOncard({"run", program});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "choice: n = 3\nthread 0 t0: finished, result 3\nn = 3\n");
  EXPECT_THAT(RunOncard({"--lang=zh", "run", program}).out, testing::StartsWith("选择：n = 3\n"));
  EXPECT_EQ(Json::parse(RunOncard({"run", program, "--format=json"}).out)["choice"], "n = 3");
}

TEST(RunChoices, ASeedDrawsOthers) {
  const ScratchFolder scratch;
  const std::string program = scratch.Write("p.c", kOpen);
  bool other = false;
  for (int seed = 1; seed <= 10; ++seed) {
    const Json json = Json::parse(
        RunOncard({"run", program, "--seed", std::to_string(seed), "--format=json"}).out);
    EXPECT_EQ(json["choice"], "n = " + json["values"]["n"].dump());
    other = other || json["values"]["n"] != 3;
  }
  EXPECT_TRUE(other);
  const ProcessResult none = RunOncard({"run", kSum, "--seed", "1"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("remove the seed"));
}

TEST(RunChoices, WhatIsSetIsNoChoice) {
  const ScratchFolder scratch;
  EXPECT_EQ(RunOncard({"run", scratch.Write("p.c", kOpen), "--set", "n=7"}).out,
            "thread 0 t0: finished, result 7\nn = 7\n");
}

// An array that is set whole does not say which of its elements were left open on purpose.
TEST(RunChoices, AnArrayIsNotSetOverAChoiceOfAnElement) {
  const ScratchFolder scratch;
  const std::string program =
      scratch.Write("p.c", "int a[3];\n//@ input: a[1] = 1..3\nint t0()\n{\n  return 0;\n}\n");
  const ProcessResult all = RunOncard({"run", program, "--set", "a=5,2"});
  EXPECT_EQ(all.exit_code, 2) << all.out;
  EXPECT_THAT(all.err, HasSubstr("'a[1]' has a choice, and another value too"));
  EXPECT_EQ(RunOncard({"run", program, "--set", "a[1]=2"}).out,
            "thread 0 t0: finished, result 0\na = [0, 2, 0]\n");
}

TEST(RunChoices, ARecordingHasWhatWasChosen) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kOpen);
  const ProcessResult run =
      RunOncard({"run", "p.c", "--seed", "2", "--record", "r.schedule"}, scratch.path());
  const ProcessResult replay = RunOncard({"replay", "r.schedule"}, scratch.path());
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_THAT(run.out, testing::EndsWith('\n' + replay.out));
  EXPECT_THAT(scratch.Read("r.schedule"), testing::Not(HasSubstr("any")));
}

TEST(RunChoices, ATestSaysWhichCaseItRan) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kOpen);
  scratch.Write("s.toml",
                "program = \"p.c\"\nexpect = [\"n == 4\"]\nglobals = { n = { any = [4, 5] } }\n");
  const ProcessResult test = RunOncard({"test", "s.toml"}, scratch.path());
  EXPECT_EQ(test.exit_code, 0) << test.out;
  EXPECT_THAT(test.out + test.err, HasSubstr("choice: n = 4"));
}

}  // namespace
}  // namespace oncard::tools
