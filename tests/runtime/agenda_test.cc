#include "runtime/scenario/run/agenda.h"

#include <gmock/gmock.h>

#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kAgendaProgram = "int x;\nint y;\nint f()\n{\n  x = 1;\n  return 0;\n}\n";

class AgendaTest : public testing::Test {
 protected:
  /// Reads the agenda of a scenario with cycles of 250 us.
  void Read(const std::string& text) {
    const Scenario scenario = ScenarioForTest(text);
    controller_ = std::make_unique<Controller>(CardOptions(scenario));
    EXPECT_TRUE(
        StartScenario(scenario, CompileForTest(kAgendaProgram), controller_.get(), &errors_).ok());
    agenda_.Read(scenario, controller_.get(), &errors_);
  }
  std::vector<std::string> ChecksDueAt(int64_t cycle) {
    std::vector<std::string> texts;
    while (const Agenda::Check* check = agenda_.TakeCheck(cycle)) texts.push_back(check->text);
    return texts;
  }
  std::vector<std::string> WritesDueAt(int64_t cycle) {
    std::vector<std::string> texts;
    while (const Agenda::Write* write = agenda_.TakeWrite(cycle)) {
      texts.push_back(fmt::format("{} = {}", write->variable.name, write->value));
    }
    return texts;
  }

  ScenarioErrors errors_;
  std::unique_ptr<Controller> controller_;
  Agenda agenda_;
};

TEST_F(AgendaTest, ItemsAreDueAtTheFirstCycleThatIsNotBefore) {
  Read("expect = [\"x == 1 @ 0.3ms\"]\n[[host]]\nat_ms = 0.5\nset = { y = 3 }\n");
  EXPECT_EQ(agenda_.NextCycle(), 2);
  EXPECT_THAT(ChecksDueAt(1), ElementsAre());
  EXPECT_THAT(ChecksDueAt(2), ElementsAre("x == 1 @ 0.3ms"));
  EXPECT_FALSE(agenda_.has_checks());
  EXPECT_THAT(WritesDueAt(2), ElementsAre("y = 3"));
  EXPECT_EQ(agenda_.NextCycle(), INT64_MAX);
}

TEST_F(AgendaTest, ChecksAreInTheOrderOfTimeAndOfTheFile) {
  Read("expect = [\"x == 3 @ 2ms\", \"x == 1 @ 1ms\", \"x == 2 @ 1ms\", \"x == 4\"]\n");
  EXPECT_THAT(ChecksDueAt(4), ElementsAre("x == 1 @ 1ms", "x == 2 @ 1ms"));
  EXPECT_THAT(ChecksDueAt(100), ElementsAre("x == 3 @ 2ms"));
  ASSERT_EQ(agenda_.at_end().size(), 1u);
  EXPECT_EQ(agenda_.at_end()[0].text, "x == 4");
}

TEST_F(AgendaTest, CanBePutBack) {
  Read("expect = [\"x == 1 @ 1ms\"]\n[[host]]\nat_ms = 1\nset = { x = 3, y = 4 }\n");
  const Agenda::Position start = agenda_.position();
  EXPECT_THAT(ChecksDueAt(4), ElementsAre("x == 1 @ 1ms"));
  EXPECT_THAT(WritesDueAt(4), ElementsAre("x = 3", "y = 4"));
  agenda_.GoTo(start);
  EXPECT_THAT(ChecksDueAt(4), ElementsAre("x == 1 @ 1ms"));
  EXPECT_THAT(WritesDueAt(4), ElementsAre("x = 3", "y = 4"));
}

TEST_F(AgendaTest, WritesWithinACycleAreDueAfterTheirStatements) {
  Read(
      "[[host]]\nat_ms = 0.5\nset = { x = 1 }\n"
      "[[host]]\nat_ms = 0.5\nafter_statements = 7\nset = { x = 2 }\n"
      "[[host]]\nat_ms = 0.3\nafter_statements = 5\nset = { y = 3 }\n"
      "[[host]]\nat_ms = 0.4\nafter_statements = 9\nset = { y = 4 }\n");
  EXPECT_EQ(agenda_.NextCycle(), 2);
  EXPECT_EQ(agenda_.NextWithin(1), Agenda::kAtEnd);
  EXPECT_EQ(agenda_.NextWithin(2), 5);
  EXPECT_EQ(agenda_.TakeWriteWithin(2, 4), nullptr);
  ASSERT_NE(agenda_.TakeWriteWithin(2, 5), nullptr);
  EXPECT_EQ(agenda_.TakeWriteWithin(2, 5), nullptr);
  EXPECT_EQ(agenda_.NextWithin(2), 7);
  // What has not been taken within the cycle is due at its end.
  EXPECT_THAT(WritesDueAt(2), ElementsAre("x = 2", "y = 4", "x = 1"));
}

TEST_F(AgendaTest, ReadingChangesNothing) {
  Read("[[host]]\nat_ms = 1\nset = { x = 3 }\n");
  EXPECT_EQ(controller_->machine().state().globals[0], 0);
}

TEST_F(AgendaTest, KnowsWhichFaultsAreExpected) {
  Read("expect = [\"thread2.error == 100\"]\n[[thread]]\nthread = 2\nfunction = \"f\"\n");
  EXPECT_TRUE(agenda_.ExpectsFault(2));
  EXPECT_FALSE(agenda_.ExpectsFault(0));
}

TEST_F(AgendaTest, ReportsNamesThatDoNotExist) {
  Read("expect = [\"z == 1\"]\n[[host]]\nat_ms = 1\nset = { w = 3 }\n");
  const auto failure = errors_.Failure();
  ASSERT_TRUE(failure.has_value());
  EXPECT_THAT(failure->message.en, HasSubstr("nothing is named 'z'"));
  EXPECT_THAT(failure->message.en, HasSubstr("nothing is named 'w'"));
}

}  // namespace
}  // namespace oncard::runtime
