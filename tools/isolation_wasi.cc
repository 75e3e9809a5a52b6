// In WebAssembly, which has no processes: the system (web/cli/src/tests.ts) starts this command
// again with the same arguments, several times at once, and each of these takes tests from its list
// until none is left. One that ends within a test is replaced by another.
#include <cstdlib>
#include <string>

#include "tools/invocation.h"
#include "tools/isolation.h"
#include "tools/packed_outcome.h"

#define ONCARD_SYSTEM(name) __attribute__((import_module("oncard"), import_name(#name)))

extern "C" {

// 1 in a command that was started to run tests.
ONCARD_SYSTEM(runs_tests) int32_t oncard_runs_tests();
// The number of the next test to run; -1: there is none.
ONCARD_SYSTEM(next_test) int32_t oncard_next_test();
ONCARD_SYSTEM(give_outcome)
void oncard_give_outcome(int32_t test, const char* text, size_t size);

// Runs all tests in other commands.
ONCARD_SYSTEM(run_tests)
void oncard_run_tests(int32_t tests, int32_t jobs, int32_t timeout_s);
// How the command ended that ran a test: the size of the test's outcome, or kCrashed ...
ONCARD_SYSTEM(outcome_size) int32_t oncard_outcome_size(int32_t test);
ONCARD_SYSTEM(take_outcome) void oncard_take_outcome(int32_t test, char* text);

}  // extern "C"

namespace oncard::tools {
namespace {

// In place of the size of an outcome: the command crashed, was ended at the time limit, or ended by
// itself, with an exit code that is subtracted.
constexpr int32_t kCrashed = -1;
constexpr int32_t kTookTooLong = -2;
constexpr int32_t kExited = -16;

Message DescribeTestEnd(int32_t end, const IsolationOptions& options) {
  if (end == kTookTooLong) return TookTooLong(options.timeout_s);
  return end == kCrashed ? DescribeCrash("trap") : DescribeExit(kExited - end);
}

[[noreturn]] void RunTests(const std::vector<IsolatedTest>& tests) {
  for (int32_t test = 0; (test = oncard_next_test()) >= 0;) {
    const std::string text = PackedOutcomeOf(tests[static_cast<size_t>(test)].work);
    oncard_give_outcome(test, text.data(), text.size());
  }
  std::_Exit(kExitOk);
}

}  // namespace

std::vector<TestOutcome> RunIsolated(const std::vector<IsolatedTest>& tests,
                                     const IsolationOptions& options,
                                     const std::atomic<bool>& /*stop*/) {
  if (oncard_runs_tests() != 0) RunTests(tests);
  std::vector<TestOutcome> outcomes;
  for (const IsolatedTest& test : tests) outcomes.push_back(test.named);
  const auto count = static_cast<int32_t>(tests.size());
  oncard_run_tests(count, options.jobs, options.timeout_s);
  for (int32_t test = 0; test < count; ++test) {
    TestOutcome& outcome = outcomes[static_cast<size_t>(test)];
    const int32_t size = oncard_outcome_size(test);
    std::string text(size < 0 ? 0 : static_cast<size_t>(size), '\0');
    if (size >= 0) oncard_take_outcome(test, text.data());
    if (size >= 0 && UnpackOutcome(text, &outcome)) continue;
    outcome.failures.push_back(DescribeTestEnd(size < 0 ? size : kCrashed, options));
  }
  return outcomes;
}

}  // namespace oncard::tools
