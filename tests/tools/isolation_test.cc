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

TestOutcome Named(const std::string& path) {
  TestOutcome named;
  named.path = path;
  return named;
}

TestOutcome RunOne(const std::function<TestOutcome()>& work, const std::atomic<bool>& stop,
                   const IsolationOptions& options = {}) {
  return RunIsolated({{Named("x.toml"), work}}, options, stop).at(0);
}

/// The only failure, in English.
std::string FailureOf(const std::function<TestOutcome()>& work,
                      const std::atomic<bool>& stop = kGoOn) {
  const TestOutcome outcome = RunOne(work, stop);
  EXPECT_EQ(outcome.path, "x.toml");
  return outcome.failures.size() == 1 ? outcome.failures[0].en : "";
}

TEST(RunIsolated, GivesWhatTheWorkGives) {
  TestOutcome made;
  made.failures = {{"one \xff", "一"}, {"two", "二"}};
  made.warnings = {{"three", "三"}};
  made.nothing = {"four", "四"};
  made.skipped = {"five", "五"};
  made.time_ms = 0.1;
  made.search_ms = 0.2;
  made.statements = 7;
  const TestOutcome outcome = RunOne([&] { return made; }, kGoOn);
  ASSERT_EQ(outcome.failures.size(), 2u);
  EXPECT_EQ(outcome.failures[0].en, "one \xEF\xBF\xBD");
  EXPECT_EQ(outcome.failures[1].zh, "二");
  EXPECT_EQ(outcome.warnings.at(0).en, "three");
  EXPECT_EQ(outcome.nothing.zh, "四");
  EXPECT_EQ(outcome.skipped.en, "five");
  EXPECT_EQ(outcome.time_ms, 0.1);
  EXPECT_EQ(outcome.search_ms, 0.2);
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

const std::function<TestOutcome()> kEndless = []() -> TestOutcome {
  for (;;) ::pause();
};

TEST(RunIsolated, EndsAWorkThatIsToStop) {
  static std::atomic<bool> stop = false;
  ::signal(SIGALRM, [](int) { stop = true; });
  ::ualarm(50'000, 0);
  const TestOutcome outcome = RunOne(kEndless, stop);
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_EQ(outcome.failures.at(0).en, "interrupted");
}

TEST(RunIsolated, DoesNotBeginWhenItIsToStop) {
  const TestOutcome outcome = RunOne(kEndless, true);
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_EQ(outcome.failures.at(0).en, "not run: interrupted");
}

TEST(RunIsolated, AnEndlessWorkHarmsNoOther) {
  IsolationOptions options;
  options.jobs = 2;
  options.timeout_s = 1;
  std::vector<IsolatedTest> tests;
  tests.push_back({Named("endless"), kEndless});
  for (const char* name : {"a", "b", "c"}) {
    tests.push_back({Named(name), [name] {
                       TestOutcome outcome;
                       outcome.warnings = {{name, name}};
                       return outcome;
                     }});
  }
  const std::vector<TestOutcome> outcomes = RunIsolated(tests, options, kGoOn);
  ASSERT_EQ(outcomes.size(), 4u);
  EXPECT_EQ(outcomes[0].failures.at(0).en, "it took longer than 1 s: --timeout sets the limit");
  EXPECT_FALSE(outcomes[0].interrupted);
  for (size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(outcomes[i].status(), TestStatus::kPassed);
    EXPECT_EQ(outcomes[i].warnings.at(0).en, outcomes[i].path);
  }
}

}  // namespace
}  // namespace oncard::tools
