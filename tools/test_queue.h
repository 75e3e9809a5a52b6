// The tests that isolation.cc and isolation_windows.cc run in processes: which one begins next, and
// the outcomes of all.
#pragma once

#include <algorithm>
#include <atomic>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/isolation.h"

namespace oncard::tools {

class TestQueue {
 public:
  /// All must outlive this object.
  TestQueue(const std::vector<IsolatedTest>& tests, const IsolationOptions& options,
            const std::atomic<bool>& stop)
      : jobs_(static_cast<size_t>(std::max(1, options.jobs))), stop_(stop) {
    for (const IsolatedTest& test : tests) outcomes_.push_back(test.named);
  }

  /// The next test to begin while so many run; nothing if none can now. Once the run has been
  /// stopped, none begins any more.
  std::optional<size_t> Next(size_t running) {
    while (stop_ && next_ < outcomes_.size()) {
      Interrupt(next_++, {"not run: interrupted", "未运行：被中断"});
    }
    if (next_ == outcomes_.size() || running >= jobs_) return std::nullopt;
    return next_++;
  }

  TestOutcome& outcome(size_t test) { return outcomes_[test]; }
  std::vector<TestOutcome> TakeOutcomes() { return std::move(outcomes_); }

  /// For a test whose process cannot be started.
  void NotStarted(size_t test, std::string_view why) {
    outcomes_[test].failures.push_back(
        MakeMessage("cannot start a process for it: {0}", "无法为其启动进程：{0}", why));
  }

  /// For a test whose process was ended because the run was stopped.
  void Interrupted(size_t test) { Interrupt(test, {"interrupted", "被中断"}); }

 private:
  void Interrupt(size_t test, const Message& how) {
    outcomes_[test].interrupted = true;
    outcomes_[test].failures.push_back(how);
  }

  const size_t jobs_;
  const std::atomic<bool>& stop_;
  std::vector<TestOutcome> outcomes_;
  size_t next_ = 0;  ///< test to begin
};

}  // namespace oncard::tools
