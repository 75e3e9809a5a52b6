// Converts comments of a source to a problem (explore/models/problem.h).
#include "explore/models/problem.h"

#include <gtest/gtest.h>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

vm::Object ObjectWith(std::initializer_list<const char*> functions) {
  vm::Object object;
  for (const char* name : functions) {
    object.functions.emplace_back();
    object.functions.back().name = name;
  }
  return object;
}

TEST(ProblemTest, CommentsAreRead) {
  const auto read = ReadComments("dir/p.c",
                                 "int g, h; //@ not at the line's begin\n"
                                 "//@ init: g=1, h=-5\n"
                                 "  //@ final: g == 1\n"
                                 "//@ never: h > 0\n"
                                 "//@ always: h < 0\n",
                                 ObjectWith({"t0", "t1", "t3"}));
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  const runtime::Scenario& scenario = read.value().scenario;
  EXPECT_EQ(scenario.program, "p.c");
  ASSERT_EQ(scenario.threads.size(), 2u);
  EXPECT_EQ(scenario.threads[1].function, "t1");
  EXPECT_EQ(scenario.threads[1].page, 1);
  ASSERT_EQ(scenario.globals.size(), 2u);
  EXPECT_EQ(scenario.globals[1].name, "h");
  EXPECT_EQ(scenario.globals[1].values, std::vector<double>{-5});
  ASSERT_EQ(read.value().requirements.size(), 3u);
  EXPECT_EQ(read.value().requirements[1].scope, Scope::kNever);
  EXPECT_EQ(read.value().requirements[1].text, "h > 0");
}

TEST(ProblemTest, ACommentThatSaysNothingIsAnError) {
  for (const char* comment :
       {"//@ finally: x == 1", "//@ final:", "//@", "//@ init: x", "//@ endless: yes",
        "//@ endless:", "//@ livelock: benign", "//@ deadlock"}) {
    const auto read = ReadComments("p.c", std::string("\n") + comment, ObjectWith({"t0"}));
    ASSERT_FALSE(read.ok()) << comment;
    EXPECT_EQ(read.error().message.en.substr(0, 6), "p.c:2:") << comment;
  }
}

TEST(ProblemTest, InputsAreRangesOfWholeNumbers) {
  const auto read = ReadComments("p.c", "//@ input: x = 0..3, a[2] = -1..1\n", ObjectWith({"t0"}));
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  const auto& globals = read.value().scenario.globals;
  ASSERT_EQ(globals.size(), 2u);
  EXPECT_EQ(globals[0].values, std::vector<double>{0});
  EXPECT_EQ(globals[0].last, 3);
  EXPECT_EQ(globals[1].name, "a[2]");
  EXPECT_EQ(globals[1].values, std::vector<double>{-1});
  EXPECT_EQ(globals[1].last, 1);
  for (const char* comment : {"x", "x = 3", "x = 3..1", "x = 1.5..2", "x = 1..", "= 1..2",
                              "x = 1..99999999999999999999", "x = -9007199254740993..0"}) {
    const auto wrong =
        ReadComments("p.c", std::string("//@ input: ") + comment + '\n', ObjectWith({"t0"}));
    ASSERT_FALSE(wrong.ok()) << comment;
    EXPECT_NE(wrong.error().message.en.find("is not a choice"), std::string::npos) << comment;
  }
}

TEST(ProblemTest, CommentsSayWhichRunsNeedNoEnd) {
  const auto read = ReadComments("p.c", "//@ livelock: any\n//@ deadlock: any\n//@ endless\n",
                                 ObjectWith({"t0"}));
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  EXPECT_TRUE(read.value().scenario.endless);
  EXPECT_EQ(read.value().scenario.livelock, "any");
  EXPECT_EQ(read.value().scenario.deadlock, "any");
  EXPECT_TRUE(read.value().of_all_schedules.empty());
}

TEST(ProblemTest, AnEndlessProgramHasNoRequirementsOnItsEnd) {
  for (const char* comment : {"//@ final: x == 1", "//@ eventually: x == 1"}) {
    const auto read =
        ReadComments("p.c", std::string("//@ endless\n") + comment, ObjectWith({"t0"}));
    ASSERT_FALSE(read.ok()) << comment;
    EXPECT_EQ(read.error().message.en.substr(0, 6), "p.c:2:") << comment;
  }
}

TEST(ProblemTest, ThreadsAreNamed) {
  EXPECT_FALSE(ReadComments("p.c", "", ObjectWith({"main", "t1"})).ok());
}

TEST(ProblemTest, FaultsOfAState) {
  Problem problem = ProblemOf(
      "int x;\n//@ never: x == 1\n//@ final: x == 3\n"
      "int t0() {\n  x = 1;\n  x = 2;\n  x = x / 0;\n  return 0;\n}\n");
  EXPECT_TRUE(problem.HasInvariants());
  EXPECT_FALSE(FindFault(problem, problem.model));
  problem.model.Step(0);
  EXPECT_EQ(FindFault(problem, problem.model).kind, Fault::Kind::kRequirement);
  EXPECT_EQ(FindFault(problem, problem.model).requirement, 0);
  problem.model.Step(0);
  EXPECT_FALSE(FindFault(problem, problem.model));
  problem.model.Step(0);
  EXPECT_EQ(FindFault(problem, problem.model).kind, Fault::Kind::kThread);
}

}  // namespace
}  // namespace oncard::explore
