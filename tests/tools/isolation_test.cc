// Tests that do not end normally.
#include "tools/isolation.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <new>
#include <stdexcept>

namespace oncard::tools {
namespace {

const std::atomic<bool> kGoOn = false;

/// The only failure, in English.
std::string FailureOf(const std::function<TestOutcome()>& work,
                      const std::atomic<bool>& stop = kGoOn) {
  const TestOutcome outcome = RunIsolated("x.toml", work, stop);
  EXPECT_EQ(outcome.path, "x.toml");
  return outcome.failures.size() == 1 ? outcome.failures[0].en : "";
}

TEST(RunIsolated, GivesWhatTheWorkGives) {
  TestOutcome made;
  made.failures = {{"one \xff", "一"}, {"two", "二"}};
  made.warnings = {{"three", "三"}};
  made.time_ms = 0.1;
  made.statements = 7;
  const TestOutcome outcome = RunIsolated(
      "x.toml", [&] { return made; }, kGoOn);
  ASSERT_EQ(outcome.failures.size(), 2u);
  EXPECT_EQ(outcome.failures[0].en, "one \xEF\xBF\xBD");
  EXPECT_EQ(outcome.failures[1].zh, "二");
  EXPECT_EQ(outcome.warnings.at(0).en, "three");
  EXPECT_EQ(outcome.time_ms, 0.1);
  EXPECT_EQ(outcome.statements, 7);
  EXPECT_FALSE(outcome.interrupted);
}

TEST(RunIsolated, HasRoomForALongReport) {
  TestOutcome made;
  made.failures = {{std::string(1 << 20, 'x'), "长"}};
  EXPECT_EQ(FailureOf([&] { return made; }).size(), size_t{1} << 20);
}

TEST(RunIsolated, SurvivesWhateverBecomesOfTheWork) {
  EXPECT_EQ(FailureOf([]() -> TestOutcome {
              ::signal(SIGSEGV, SIG_DFL);
              ::raise(SIGSEGV);
              return {};
            }),
            "oncard itself crashed on this file (Segmentation fault): please report it");
  EXPECT_EQ(FailureOf([]() -> TestOutcome {
              ::signal(SIGABRT, SIG_DFL);
              std::abort();
            }),
            "oncard itself crashed on this file (Aborted): please report it");
  EXPECT_EQ(FailureOf([]() -> TestOutcome { ::_exit(3); }),
            "oncard ended unexpectedly on this file (exit code 3): please report it");
  EXPECT_EQ(FailureOf([]() -> TestOutcome { ::_exit(0); }),
            "oncard ended unexpectedly on this file (exit code 0): please report it");
  EXPECT_EQ(FailureOf([]() -> TestOutcome { throw std::runtime_error("no reason"); }),
            "internal error: no reason");
}

TEST(RunIsolated, EndsAWorkThatIsToStop) {
  const std::atomic<bool> stop = true;
  const TestOutcome outcome = RunIsolated(
      "x.toml",
      []() -> TestOutcome {
        for (;;) ::pause();
      },
      stop);
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_EQ(outcome.failures.at(0).en, "interrupted");
}

}  // namespace
}  // namespace oncard::tools
