#include "runtime/scenario/run/run_course.h"

#include <gmock/gmock.h>

#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// f() ends in its first cycle, g() waits for `go`, h() never ends.
constexpr const char* kCourseProgram =
    "int go, x;\nint f()\n{\n  return 0;\n}\n"
    "int g()\n{\n  GT_WaitForVarEq(&go, 1);\n  return 0;\n}\n"
    "int h()\n{\nlbl:\n  goto lbl;\n}\n";

class RunCourseTest : public testing::Test {
 protected:
  /// Starts the function in a scenario with cycles of 250 us.
  void Start(const std::string& function, const std::string& text) {
    const Scenario scenario =
        ScenarioForTest(text + "[[thread]]\nfunction = \"" + function + "\"\n");
    controller_ = std::make_unique<Controller>(CardOptions(scenario));
    ScenarioErrors errors;
    EXPECT_TRUE(
        StartScenario(scenario, CompileForTest(kCourseProgram), controller_.get(), &errors).ok());
    course_.Read(scenario, controller_.get(), &errors);
    EXPECT_FALSE(errors.Failure());
  }
  /// What the course does at this boundary.
  static std::vector<std::string> Act(RunCourse* course, Controller* controller) {
    std::vector<std::string> done;
    course->Act(
        controller, [&](const Agenda::Check& check) { done.push_back(check.text); },
        [&](const Agenda::Write& write) {
          done.push_back(fmt::format("{} = {}", write.variable.name, write.value));
        });
    return done;
  }
  /// The cycle in which the run is over, and why; at most 1000.
  std::pair<int64_t, std::optional<RunOver>> RunToEnd() {
    for (;;) {
      Act(&course_, controller_.get());
      const auto over = course_.Over(*controller_);
      if (over || controller_->cycle() == 1000) return {controller_->cycle(), over};
      controller_->RunCycle();
    }
  }

  std::unique_ptr<Controller> controller_;
  RunCourse course_;
};

using End = std::pair<int64_t, std::optional<RunOver>>;

TEST_F(RunCourseTest, IsOverWhenNoThreadRuns) {
  Start("f", "");
  EXPECT_EQ(RunToEnd(), End(1, RunOver::kQuiet));
}

TEST_F(RunCourseTest, IsOverWithTheFirstOfBothBounds) {
  Start("h", "limit_ms = 3\nuntil_ms = 2\n");
  EXPECT_EQ(RunToEnd(), End(8, RunOver::kUntil));
  Start("h", "limit_ms = 2\nuntil_ms = 3\n");
  EXPECT_EQ(RunToEnd(), End(8, RunOver::kLimit));
  Start("h", "limit_ms = 2\nuntil_ms = 2\n");
  EXPECT_EQ(RunToEnd(), End(8, RunOver::kUntil));
  Start("h", "limit_ms = 2\n");
  EXPECT_EQ(RunToEnd(), End(8, RunOver::kLimit));
}

TEST_F(RunCourseTest, CutsWhatMayLastForEver) {
  for (const std::string key : {"endless = true\n", "livelock = \"any\"\n"}) {
    Start("h", key + "limit_ms = 2\n");
    EXPECT_EQ(RunToEnd(), End(8, RunOver::kUntil)) << key;
    EXPECT_TRUE(course_.bounds().CutsAt(*controller_)) << key;
    // Ended by itself.
    Start("f", key + "limit_ms = 2\n");
    EXPECT_EQ(RunToEnd(), End(1, RunOver::kQuiet)) << key;
    EXPECT_FALSE(course_.bounds().CutsAt(*controller_)) << key;
    // The end that is asked for.
    Start("h", key + "limit_ms = 3\nuntil_ms = 2\n");
    EXPECT_EQ(RunToEnd(), End(8, RunOver::kUntil)) << key;
    EXPECT_FALSE(course_.bounds().CutsAt(*controller_)) << key;
    Start("h", key + "limit_ms = 2\nuntil_ms = 3\n");
    EXPECT_EQ(RunToEnd(), End(8, RunOver::kLimit)) << key;
  }
}

TEST_F(RunCourseTest, LastsToItsEndThoughNoThreadRuns) {
  Start("f", "until_ms = 2\n");
  EXPECT_EQ(RunToEnd(), End(8, RunOver::kUntil));
  // The limit is before the end that was asked for.
  Start("f", "until_ms = 2\nlimit_ms = 1\n");
  EXPECT_EQ(RunToEnd(), End(4, RunOver::kLimit));
}

TEST_F(RunCourseTest, WaitsForExpectationsWithAnInstantButNotForWrites) {
  Start("f", "expect = [\"x == 0 @ 2ms\", \"x == 1\"]\n");
  EXPECT_EQ(RunToEnd(), End(8, RunOver::kQuiet));
  Start("f", "[[host]]\nat_ms = 2\nset = { x = 1 }\n");
  EXPECT_EQ(RunToEnd(), End(1, RunOver::kQuiet));
}

TEST_F(RunCourseTest, IsNoDeadlockWhileAWriteIsLeft) {
  Start("g", "[[host]]\nat_ms = 2\nset = { go = 1 }\n");
  // The thread ends in the cycle that begins then.
  EXPECT_EQ(RunToEnd(), End(9, RunOver::kQuiet));
  Start("g", "[[host]]\nat_ms = 2\nset = { x = 1 }\n");
  EXPECT_EQ(RunToEnd(), End(8, RunOver::kDeadlock));
  Start("g", "");
  EXPECT_EQ(RunToEnd(), End(1, RunOver::kDeadlock));
}

TEST_F(RunCourseTest, EvaluatesBeforeItWrites) {
  Start("h", "expect = [\"x == 0 @ 1ms\"]\nlimit_ms = 9\n[[host]]\nat_ms = 1\nset = { x = 5 }\n");
  EXPECT_EQ(course_.NextCycle(), 4);
  controller_->RunCycles(4);
  EXPECT_THAT(Act(&course_, controller_.get()), ElementsAre("x == 0 @ 1ms", "x = 5"));
  EXPECT_THAT(Act(&course_, controller_.get()), IsEmpty());
  EXPECT_EQ(course_.NextCycle(), 36);
}

TEST_F(RunCourseTest, GoesOnByItselfAsACopy) {
  Start("h", "[[host]]\nat_ms = 1\nset = { x = 5 }\n[[host]]\nat_ms = 2\nset = { x = 6 }\n");
  controller_->RunCycles(4);
  Act(&course_, controller_.get());
  RunCourse copy = course_;
  const RunCourse::Position before = course_.position();
  controller_->RunCycles(4);
  EXPECT_THAT(Act(&course_, controller_.get()), ElementsAre("x = 6"));
  EXPECT_THAT(Act(&copy, controller_.get()), ElementsAre("x = 6"));
  course_.GoTo(before);
  EXPECT_THAT(Act(&course_, controller_.get()), ElementsAre("x = 6"));
}

}  // namespace
}  // namespace oncard::runtime
