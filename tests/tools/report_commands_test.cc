// The commands test, doctor, completion and man.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;

using Json = nlohmann::json;

// Two scenarios in folders, one of which fails.
class TestCommandTest : public testing::Test {
 protected:
  void SetUp() override {
    scratch_.Write("p.c", "int f()\n{\n  return 7;\n}\n");
    scratch_.Write("b/good.toml", "program = \"../p.c\"\nexpect = [\"thread0.result == 7\"]\n");
    scratch_.Write("a/bad.toml",
                   "program = \"../p.c\"\nexpect = [\"thread0.result == 8\", \"gpo < 0\"]\n");
    scratch_.Write("b/notes.txt", "not a scenario");
  }
  ProcessResult Test(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "test");
    return RunOncard(arguments, scratch_.path());
  }
  ScratchFolder scratch_;
};

TEST_F(TestCommandTest, RunsAllBelowAFolderInOrder) {
  const ProcessResult result = Test({"."});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out,
            "FAIL ./a/bad.toml\n"
            "     thread0.result == 8: thread0.result is 7\n"
            "     gpo < 0: gpo is 0\n"
            "ok   ./b/good.toml\n"
            "1 passed, 1 failed\n");
}

TEST_F(TestCommandTest, SucceedsWhenAllPass) {
  const ProcessResult result = Test({"b/good.toml"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "ok   b/good.toml\n1 passed, 0 failed\n");
  EXPECT_EQ(result.err, "");
}

TEST_F(TestCommandTest, SpeaksChinese) {
  EXPECT_EQ(Test({"--lang=zh", "b"}).out, "ok   b/good.toml\n1 个通过，0 个失败\n");
}

TEST_F(TestCommandTest, WritesJunit) {
  EXPECT_EQ(Test({"--format=junit", "."}).out,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuite name=\"oncard\" tests=\"2\" failures=\"1\" skipped=\"0\">\n"
            "  <testcase name=\"./a/bad.toml\" time=\"0.000250\">\n"
            "    <failure message=\"thread0.result == 8: thread0.result is 7\"/>\n"
            "    <failure message=\"gpo &lt; 0: gpo is 0\"/>\n"
            "  </testcase>\n"
            "  <testcase name=\"./b/good.toml\" time=\"0.000250\"/>\n"
            "</testsuite>\n");
}

TEST_F(TestCommandTest, WritesTap) {
  EXPECT_EQ(Test({"--format=tap", "."}).out,
            "TAP version 13\n"
            "1..2\n"
            "not ok 1 - ./a/bad.toml\n"
            "# thread0.result == 8: thread0.result is 7\n"
            "# gpo < 0: gpo is 0\n"
            "ok 2 - ./b/good.toml\n");
}

TEST_F(TestCommandTest, WritesJson) {
  const Json json = Json::parse(Test({"--format=json", "."}).out);
  EXPECT_EQ(json["passed"], 1);
  EXPECT_EQ(json["failed"], 1);
  EXPECT_EQ(json["tests"][0]["path"], "./a/bad.toml");
  EXPECT_EQ(json["tests"][0]["failures"].size(), 2u);
}

TEST_F(TestCommandTest, ReportsWhatCannotBeRunAsAFailure) {
  scratch_.Write("c/broken.c", "int f()\n{\n  return x;\n}\n");
  scratch_.Write("c/compile.toml", "program = \"broken.c\"\n");
  scratch_.Write("c/missing.toml", "program = \"none.c\"\n");
  scratch_.Write("c/typo.toml", "program = \"../p.c\"\nexpct = []\n");
  const ProcessResult result = Test({"c"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("MP027"));
  EXPECT_THAT(result.out, HasSubstr("none.c"));
  EXPECT_THAT(result.out, HasSubstr("c/typo.toml:2:1"));
  EXPECT_THAT(result.out, HasSubstr("'expect'"));
  EXPECT_THAT(result.out, HasSubstr("0 passed, 3 failed"));
}

TEST_F(TestCommandTest, IsNotSatisfiedWithNothing) {
  scratch_.Write("empty/keep", "");
  EXPECT_EQ(Test({"empty"}).exit_code, 3);
  EXPECT_EQ(Test({"nowhere"}).exit_code, 3);
}

// --- Scenarios that are explored ----------------------------------------------------------------

// Three threads with 200 passes each: the search takes far longer than any limit below.
constexpr const char* kManySchedules =
    "int n;\nint f()\n{\n  int i, c;\n  i = 0;\nl:\n  n = n + i;\n  n = n * 3;\n  i = i + 1;\n"
    "  c = i < 200;\n  if (c) goto l;\n}\n";
constexpr const char* kThreeThreads =
    "[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = \"f\"\n"
    "[[thread]]\nthread = 2\nfunction = \"f\"\n";

class ExploredTest : public TestCommandTest {
 protected:
  void Write(const std::string& explore, const char* program = kManySchedules) {
    scratch_.Write("p.c", program);
    scratch_.Write("e.toml", "program = \"p.c\"\nfinal = [\"n >= 0 || n < 0\"]\nexplore = " +
                                 explore + '\n' + kThreeThreads);
  }
};

TEST_F(ExploredTest, IsNoProofWhenItsTimeIsOver) {
  for (const char* explore :
       {"\"prove\"", "{ verdict = \"INCOMPLETE\" }",
        "{ engine = \"random\", verdict = \"PASSED\", runs = 1000000000000 }"}) {
    Write(explore);
    const ProcessResult result = Test({"e.toml", "--time=0.02"});
    EXPECT_EQ(result.exit_code, 1) << explore;
    EXPECT_THAT(result.out, HasSubstr("FAIL e.toml\n     the search was ended by the time limit of "
                                      "0.02 s before it was complete: --time sets the limit\n"))
        << explore;
  }
  EXPECT_THAT(Test({"--lang=zh", "e.toml", "--time=0.02"}).out,
              HasSubstr("搜索在完成前达到时间上限 0.02 秒：可用 --time 设定上限"));
}

TEST_F(ExploredTest, IsNoProofWhenItsMemoryIsFull) {
  Write("{ engine = \"random\", verdict = \"PASSED\", runs = 1000000000000 }");
  const ProcessResult result = Test({"e.toml", "--memory=1"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("FAIL e.toml\n     the search was ended by its limit of memory "
                                    "before it was complete: --memory sets the limit\n"));
}

TEST_F(ExploredTest, KeepsTheFailureFoundInItsTime) {
  Write("{ engine = \"random\", verdict = \"FAILED\", runs = 1000000000000 }",
        "int n, z;\nint f()\n{\n  n = 1 / z;\n}\n");
  EXPECT_EQ(Test({"e.toml", "--time=5"}).out, "ok   e.toml\n1 passed, 0 failed\n");
}

TEST_F(ExploredTest, ShowsItsProgressWithItsName) {
  Write("\"prove\"");
  EXPECT_THAT(Test({"e.toml", "--time=1.5", "--progress"}).err,
              testing::ContainsRegex("e\\.toml: [0-9]+ executions"));
  EXPECT_EQ(Test({"e.toml", "--time=1.5"}).err, "") << "standard error is no terminal";
}

TEST_F(ExploredTest, HasTheTimeOfItsSearchInJunit) {
  Write("\"prove\"", "int n;\nint f()\n{\n  n = 1;\n}\n");
  const std::string report = Test({"e.toml", "--format=junit"}).out;
  EXPECT_THAT(report, testing::ContainsRegex("name=\"e\\.toml\" time=\"[0-9.]*[1-9][0-9]*\"/>"));
}

// --- Scenarios that check nothing ---------------------------------------------------------------

class EmptyTest : public TestCommandTest {
 protected:
  EmptyTest() { scratch_.Write("nothing.toml", "program = \"p.c\"\n"); }
};

TEST_F(EmptyTest, IsNoPass) {
  const ProcessResult result = Test({"b/good.toml", "nothing.toml"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out,
            "ok   b/good.toml\n"
            "none nothing.toml\n"
            "     checks nothing: it has no expectation and no requirement\n"
            "1 passed, 0 failed, 1 checked nothing\n");
  EXPECT_THAT(Test({"--lang=zh", "nothing.toml"}).out,
              HasSubstr("未检查任何内容：既没有期望也没有要求\n"
                        "0 个通过，0 个失败，1 个未检查任何内容\n"));
}

TEST_F(EmptyTest, IsSaidInEveryReport) {
  EXPECT_EQ(Test({"nothing.toml", "--format=junit"}).out,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuite name=\"oncard\" tests=\"1\" failures=\"0\" skipped=\"1\">\n"
            "  <testcase name=\"nothing.toml\" time=\"0.000250\">\n"
            "    <skipped message=\"checks nothing: it has no expectation and no requirement\"/>\n"
            "  </testcase>\n"
            "</testsuite>\n");
  EXPECT_EQ(
      Test({"nothing.toml", "--format=tap"}).out,
      "TAP version 13\n1..1\n"
      "ok 1 - nothing.toml # SKIP checks nothing: it has no expectation and no requirement\n");
  EXPECT_EQ(Test({"nothing.toml", "--format=csv"}).out,
            "scenario,program,passed,time_ms,statements,failures,warnings\r\n"
            "\"nothing.toml\",\"\",nothing,0.25,1,\"\",\"checks nothing: it has no expectation and "
            "no requirement\"\r\n");
  const Json json = Json::parse(Test({"nothing.toml", "--format=json"}).out);
  EXPECT_EQ(json["passed"], 0);
  EXPECT_EQ(json["checked_nothing"], 1);
  EXPECT_EQ(json["tests"][0]["status"], "nothing");
  EXPECT_EQ(json["tests"][0]["passed"], false);
  EXPECT_EQ(json["tests"][0]["why"], "checks nothing: it has no expectation and no requirement");
}

TEST_F(EmptyTest, FailsAsAnyOther) {
  scratch_.Write("p.c", "int n, z;\nint f()\n{\n  n = 1 / z;\n}\n");
  EXPECT_THAT(Test({"nothing.toml"}).out, HasSubstr("0 passed, 1 failed\n"));
}

struct Demand {
  const char* keys;
  bool checks;
};

class DemandTest : public EmptyTest, public testing::WithParamInterface<Demand> {};

TEST_P(DemandTest, DecidesWhetherAnythingIsChecked) {
  scratch_.Write("nothing.toml", std::string("program = \"p.c\"\n") + GetParam().keys);
  scratch_.Write("p.c", "int n;\nint f()\n{\n  n = 7;\n}\n");
  const Json json = Json::parse(Test({"nothing.toml", "--format=json"}).out);
  EXPECT_EQ(json["tests"][0]["status"], GetParam().checks ? "passed" : "nothing")
      << json["tests"][0];
}

INSTANTIATE_TEST_SUITE_P(
    Keys, DemandTest,
    testing::Values(Demand{"", false}, Demand{"expect = [\"n == 7\"]\n", true},
                    Demand{"expect = []\n", false}, Demand{"final = [\"n == 7\"]\n", true},
                    Demand{"always = [\"n < 8\"]\n", true}, Demand{"never = [\"n > 7\"]\n", true},
                    Demand{"eventually = [\"n == 7\"]\n", true},
                    Demand{"explore = \"prove\"\n", false},
                    Demand{"explore = \"prove\"\nraces = \"none\"\n", true},
                    Demand{"explore = \"prove\"\nfinal = [\"n == 7\"]\n", true},
                    Demand{"explore = { verdict = \"FAILED\" }\nfinal = [\"n == 8\"]\n", true}));

TEST_F(EmptyTest, AFailureThatIsExpectedIsChecked) {
  scratch_.Write("p.c", "int n, z;\nint f()\n{\n  n = 1 / z;\n}\n");
  scratch_.Write("nothing.toml", "program = \"p.c\"\nexplore = { verdict = \"FAILED\" }\n");
  EXPECT_EQ(Test({"nothing.toml"}).out, "ok   nothing.toml\n1 passed, 0 failed\n");
}

// --- Names of files -----------------------------------------------------------------------------

class NameTest : public TestCommandTest {
 protected:
  /// The report of a scenario with this name; it has a program that cannot be found.
  std::string Report(const std::string& name, const std::string& format) {
    scratch_.Write(name, "program = \"x.c\"\n");
    return Test({name, "--format=" + format}).out;
  }
};

TEST_F(NameTest, ForgesNoLine) {
  const std::string name = "a\nok 2 - b.toml";
  EXPECT_THAT(Report(name, "tap"), testing::StartsWith("TAP version 13\n1..1\n"
                                                       "not ok 1 - a<0A>ok 2 - b.toml\n# "));
  for (const char* format : {"text", "tap"}) {
    EXPECT_THAT(Report(name, format), testing::Not(HasSubstr("\nok"))) << format;
  }
  EXPECT_THAT(Report(name, "csv"), HasSubstr("\r\n\"a<0A>ok 2 - b.toml\",\"\",no,"));
  EXPECT_THAT(Report(name, "junit"), HasSubstr("name=\"a&lt;0A&gt;ok 2 - b.toml\""));
}

TEST_F(NameTest, IsNoDirectiveOfTap) {
  EXPECT_THAT(Report("a # SKIP \\.toml", "tap"), HasSubstr("not ok 1 - a \\# SKIP \\\\.toml\n"));
}

TEST_F(NameTest, IsNoFormula) {
  for (const char* name : {"=HYPERLINK(1).toml", "+1.toml", "@a.toml"}) {
    EXPECT_THAT(Report(name, "csv"), HasSubstr(std::string("\r\n\"'") + name + "\",")) << name;
  }
}

TEST_F(NameTest, DoesNothingToATerminal) {
  for (const char* format : {"text", "tap", "csv", "junit", "json"}) {
    EXPECT_THAT(Report("a\x1b]0;b\x07.toml", format), testing::Not(HasSubstr("\x1b"))) << format;
  }
}

// --- One scenario with many programs -------------------------------------------------------------

class ClassTest : public TestCommandTest {
 protected:
  ClassTest() {
    scratch_.Write("sum.toml",
                   "program = \"solution.c\"\nlimit_ms = 100\nexpect = [\"sum == 6\"]\n");
    scratch_.Write("hand-in/ann.c", "int sum;\nint f()\n{\n  sum = 6;\n}\n");
    scratch_.Write("hand-in/ben.c", "int sum;\nint f()\n{\n  sum = 5;\n}\n");
    scratch_.Write("hand-in/cem.c", "int sum;\nint f()\n{\n  sum = six;\n}\n");
    scratch_.Write("hand-in/dan.c", "int sum;\nint f()\n{\nl:\n  sum = 6;\n  goto l;\n}\n");
    scratch_.Write("hand-in/eve.c", "int total;\nint f()\n{\n  total = 6;\n}\n");
    scratch_.Write("hand-in/notes.txt", "");
  }
};

TEST_F(ClassTest, EveryProgramIsATest) {
  const ProcessResult result = Test({"sum.toml", "--program", "hand-in/*.c"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("ok   sum.toml: hand-in/ann.c\n"));
  EXPECT_THAT(result.out, HasSubstr("FAIL sum.toml: hand-in/ben.c\n     sum == 6: sum is 5\n"));
  EXPECT_THAT(result.out,
              HasSubstr("FAIL sum.toml: hand-in/cem.c\n     hand-in/cem.c:4:9: error MP027"));
  EXPECT_THAT(result.out, HasSubstr("threads still run at the time limit of 100 ms"));
  EXPECT_THAT(result.out, HasSubstr("sum.toml:3:11: nothing is named 'sum'"));
  EXPECT_THAT(result.out, HasSubstr("1 passed, 4 failed"));
}

TEST_F(ClassTest, TheReportDoesNotDependOnTheNumberOfJobs) {
  const std::vector<std::string> all = {"sum.toml", "--program", "hand-in/*.c", "--format=csv"};
  std::vector<std::string> one = all;
  one.push_back("--jobs=1");
  std::vector<std::string> many = all;
  many.push_back("--jobs=7");
  EXPECT_EQ(Test(one).out, Test(many).out);
}

TEST_F(ClassTest, ReportsAsCsv) {
  const ProcessResult result =
      Test({"sum.toml", "--program=hand-in/ann.c", "--program=hand-in/b*", "--format=csv"});
  EXPECT_EQ(result.out,
            "scenario,program,passed,time_ms,statements,failures,warnings\r\n"
            "\"sum.toml\",\"hand-in/ann.c\",yes,0.25,1,\"\",\"\"\r\n"
            "\"sum.toml\",\"hand-in/ben.c\",no,0.25,1,\"sum == 6: sum is 5\",\"\"\r\n");
}

TEST_F(ClassTest, ReportsAsJunit) {
  const ProcessResult result = Test({"sum.toml", "--program", "hand-in/a*", "--format=junit"});
  EXPECT_THAT(
      result.out,
      HasSubstr("<testcase classname=\"sum.toml\" name=\"hand-in/ann.c\" time=\"0.000250\"/>"));
}

TEST_F(ClassTest, APatternThatMatchesNothingIsAMistake) {
  const ProcessResult result = Test({"sum.toml", "--program", "hand-in/*.cc"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("no program matches 'hand-in/*.cc'"));
}

TEST(Doctor, TellsTheSameFactsAsTextAndJson) {
  const ProcessResult text = RunOncard({"doctor"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_EQ(text.out.rfind("oncard: ", 0), 0u) << text.out;
  const Json json = Json::parse(RunOncard({"doctor", "--format=json"}).out);
  for (const char* key : {"version", "compiler", "cpp_httplib", "eigen", "fast_float", "fmt",
                          "cards", "commands", "optional"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
}

TEST(Doctor, ListsTheCommandsOfAFamily) {
  const ProcessResult usual = RunOncard({"doctor", "--commands"});
  EXPECT_EQ(RunOncard({"doctor", "--commands", "--family=gts"}).out, usual.out);
  const ProcessResult unknown = RunOncard({"doctor", "--commands", "--family=gtx"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("--family"));
}

TEST(Doctor, ListsEveryCommandOfTheCatalogue) {
  const Json facts = Json::parse(RunOncard({"doctor", "--format=json"}).out);
  const Json list = Json::parse(RunOncard({"doctor", "--commands", "--format=json"}).out);
  EXPECT_EQ(std::to_string(list.size()), facts["commands"]);
  const std::string text = RunOncard({"doctor", "--commands"}).out;
  EXPECT_THAT(text, HasSubstr("GT_Delay "));
  for (const Json& command : list) {
    if (command["name"] == "GT_SetDo") {
      EXPECT_EQ(command["implemented"], true);
    }
  }
}

class CompletionTest : public testing::TestWithParam<const char*> {};

TEST_P(CompletionTest, MentionsEveryCommandAndOption) {
  const ProcessResult result = RunOncard({"completion", GetParam()});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* command : kCommands) {
    EXPECT_THAT(result.out, HasSubstr(command));
  }
  for (const char* option : {"vendor-format", "thread", "schedule", "max-errors", "lang"}) {
    EXPECT_THAT(result.out, HasSubstr(option));
  }
}

INSTANTIATE_TEST_SUITE_P(Shells, CompletionTest, testing::Values("bash", "zsh", "fish"));

TEST(Completion, KnowsNoOtherShell) { EXPECT_EQ(RunOncard({"completion", "csh"}).exit_code, 2); }

TEST(Man, HasTheSectionsOfAManualPage) {
  const std::string page = RunOncard({"man"}).out;
  EXPECT_EQ(page.rfind(".TH ONCARD 1 ", 0), 0u);
  for (const char* section :
       {".SH NAME\noncard \\- ", ".SH SYNOPSIS", ".SH COMMANDS", ".SH EXIT STATUS"}) {
    EXPECT_THAT(page, HasSubstr(section));
  }
  for (const char* command : kCommands) {
    EXPECT_THAT(page, HasSubstr(std::string("oncard ") + command)) << command;
  }
}

}  // namespace
}  // namespace oncard::tools
