// In place of isolation.cc on Windows, where a process cannot be copied: the command starts itself
// with the same command line, and a variable says which test the new process is for. It finds the
// same tests, does the work of that one and gives its outcome on standard output, a scratch file.
#include <windows.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "base/number.h"
#include "tools/child_windows.h"
#include "tools/invocation.h"
#include "tools/isolation.h"
#include "tools/packed_outcome.h"
#include "tools/test_queue.h"

namespace oncard::tools {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kVariable = "ONCARD_ISOLATED_TEST";
/// How often it is checked which processes have ended, and how long they may take to end. Ctrl-C
/// reaches them, too.
constexpr int kLookMs = 5;
constexpr auto kTimeToEnd = std::chrono::seconds(2);
/// The exit code of a process that was killed.
constexpr UINT kKilled = 1;
/// Exit codes above are the numbers of exceptions, such as an access to a wrong address.
constexpr DWORD kExceptions = 0xC0000000;

std::string OwnProgram() {
  std::array<char, 32'768> name;  // as long as a name can be
  return {name.data(), ::GetModuleFileNameA(nullptr, name.data(), static_cast<DWORD>(name.size()))};
}

/// A test that runs.
struct Running {
  size_t test = 0;
  SystemHandle process;
  SystemHandle output;
  std::optional<Clock::time_point> killed_at;  ///< when it is killed at the latest
};

class IsolatedRuns {
 public:
  IsolatedRuns(const std::vector<IsolatedTest>& tests, const IsolationOptions& options,
               const std::atomic<bool>& stop)
      : options_(options), stop_(stop), queue_(tests, options, stop) {}

  std::vector<TestOutcome> Run() {
    for (;;) {
      while (const auto test = queue_.Next(running_.size())) Begin(*test);
      if (running_.empty()) return queue_.TakeOutcomes();
      std::erase_if(running_, [this](Running& running) { return HasEnded(running); });
      if (!running_.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(kLookMs));
    }
  }

 private:
  void Begin(size_t test) {
    Running running;
    running.test = test;
    running.output = ScratchFile();
    ::SetEnvironmentVariableA(kVariable, std::to_string(test).c_str());
    auto started =
        StartChild(OwnProgram(), ::GetCommandLineA(),
                   {.out = running.output.get(), .err = ::GetStdHandle(STD_ERROR_HANDLE)});
    ::SetEnvironmentVariableA(kVariable, nullptr);
    if (!started.ok()) {
      return queue_.NotStarted(test, started.error().message.en);
    }
    running.process = std::move(started).value();
    if (options_.timeout_s > 0) {
      running.killed_at = Clock::now() + std::chrono::seconds(options_.timeout_s);
    }
    running_.push_back(std::move(running));
  }

  bool HasEnded(Running& running) {
    if (stop_) {
      const auto soon = Clock::now() + kTimeToEnd;
      running.killed_at = std::min(running.killed_at.value_or(soon), soon);
    }
    const bool ended = ::WaitForSingleObject(running.process.get(), 0) == WAIT_OBJECT_0;
    const bool late = running.killed_at && Clock::now() >= *running.killed_at;
    if (!ended && !late) return false;
    if (!ended) {
      ::TerminateProcess(running.process.get(), kKilled);
      ::WaitForSingleObject(running.process.get(), INFINITE);
    }
    Report(running, !ended);
    return true;
  }

  void Report(const Running& running, bool killed) {
    TestOutcome& outcome = queue_.outcome(running.test);
    DWORD code = 0;
    ::GetExitCodeProcess(running.process.get(), &code);
    if (code == 0 && UnpackOutcome(ContentOf(running.output), &outcome)) return;
    if (stop_) {
      queue_.Interrupted(running.test);
    } else if (killed) {
      outcome.failures.push_back(TookTooLong(options_.timeout_s));
    } else if (code >= kExceptions) {
      outcome.failures.push_back(DescribeCrash(fmt::format("{:#x}", code)));
    } else {
      outcome.failures.push_back(DescribeExit(static_cast<int>(code)));
    }
  }

  const IsolationOptions& options_;
  const std::atomic<bool>& stop_;
  TestQueue queue_;
  std::vector<Running> running_;
};

/// In a process that was started for one test.
[[noreturn]] void DoOne(const std::vector<IsolatedTest>& tests, std::string_view number) {
  const auto test = ReadWhole<size_t>(number);
  if (!test || *test >= tests.size()) std::_Exit(kExitInternal);
  PrintResult(PackedOutcomeOf(tests[*test].work));
  std::_Exit(std::fflush(stdout) == 0 ? kExitOk : kExitInternal);
}

}  // namespace

std::vector<TestOutcome> RunIsolated(const std::vector<IsolatedTest>& tests,
                                     const IsolationOptions& options,
                                     const std::atomic<bool>& stop) {
  if (const char* number = std::getenv(kVariable)) DoOne(tests, number);
  return IsolatedRuns(tests, options, stop).Run();
}

}  // namespace oncard::tools
