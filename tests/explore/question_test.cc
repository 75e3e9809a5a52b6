// What is asked of a file that comes by content (explore/question.h).
#include "explore/question.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/compiler.h"
#include "explore/scenario_exploration.h"
#include "explore_programs.h"
#include "tests/compiler/memory_files.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class QuestionTest : public testing::Test {
 protected:
  QuestionTest()
      : source_(Increments(2, 1)),
        object_(*compiler::CompileText("program.c", source_, {}, compiler::NoFiles()).object) {}

  /// That of a file of which the rest of the scenario says nothing.
  Question Asked(const std::string& main) const {
    runtime::Scenario scenario;
    scenario.program = "program.c";
    scenario.structured = true;
    scenario.final = {"x >= 0"};
    auto question = QuestionOf(main, scenario, source_, object_);
    EXPECT_TRUE(question.ok());
    return question.value();
  }

  const std::string source_;
  const vm::Object object_;
};

TEST_F(QuestionTest, OfAProgramByItselfIsInItsComments) {
  const Question question = Asked("program.c");
  EXPECT_EQ(question.scenario.threads.size(), 2u);
  EXPECT_TRUE(question.scenario.structured);
  ASSERT_EQ(question.requirements.size(), 1u);
  EXPECT_EQ(question.requirements[0].text, "x == 2");
}

TEST_F(QuestionTest, OfAScenarioIsInTheScenario) {
  const Question question = Asked("scenario.toml");
  EXPECT_TRUE(question.scenario.threads.empty());
  ASSERT_EQ(question.requirements.size(), 1u);
  EXPECT_EQ(question.requirements[0].text, "x >= 0");
}

TEST_F(QuestionTest, NamesTheFileOfAScheduleThatCannotBeRead) {
  Question question = Asked("program.c");
  question.scenario.path = "dir/scenario.toml";
  question.scenario.explore.emplace().follow = "lost.schedule";
  const auto found = FollowWished(question, object_, source_,
                                  compiler::ReaderOf({{"dir/lost.schedule", "no schedule"}}));
  ASSERT_FALSE(found.ok());
  EXPECT_THAT(found.error().message.en, StartsWith("dir/lost.schedule: "));
  EXPECT_THAT(found.error().message.zh, StartsWith("dir/lost.schedule："));
}

TEST_F(QuestionTest, PutsTheScheduleOfAFailureBesideTheFile) {
  const Question question = Asked("program.c");
  const auto found = ExploreScenario(question.scenario, question.requirements, object_, {});
  ASSERT_TRUE(found.ok());
  ASSERT_TRUE(found.value().exploration.failure);
  // The dot of a folder does not begin an ending.
  for (const char* const main : {"dir.d/program.c", "dir.d/program"}) {
    const auto text = FailureScheduleBeside(main, question, object_, found.value());
    ASSERT_TRUE(text.ok());
    EXPECT_THAT(text.value(), HasSubstr("program = \"../program.c\""));
  }
}

}  // namespace
}  // namespace oncard::explore
