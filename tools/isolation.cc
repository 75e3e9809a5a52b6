#include "tools/isolation.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <string>

#include "tools/child_process.h"
#include "tools/packed_outcome.h"
#include "tools/test_queue.h"

namespace oncard::tools {
namespace {

using Clock = std::chrono::steady_clock;

/// How often the parent checks whether it must stop, and how long a child may take to end.
constexpr int kLookMs = 100;
constexpr auto kTimeToEnd = std::chrono::seconds(2);

[[noreturn]] void WorkAndEnd(const std::function<TestOutcome()>& work, int descriptor) {
  const std::string text = PackedOutcomeOf(work);
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) ::_exit(1);
    rest.remove_prefix(static_cast<size_t>(written));
  }
  ::_exit(0);
}

Message DescribeEnd(int status) {
  return WIFSIGNALED(status) ? DescribeCrash(::strsignal(WTERMSIG(status)))
                             : DescribeExit(WEXITSTATUS(status));
}

/// A test that runs.
struct Child {
  size_t test = 0;
  pid_t process = -1;
  int descriptor = -1;
  std::string text;
  std::optional<Clock::time_point> killed_at;  ///< when it is killed at the latest
  bool told_to_stop = false;
};

class IsolatedRuns {
 public:
  IsolatedRuns(const std::vector<IsolatedTest>& tests, const IsolationOptions& options,
               const std::atomic<bool>& stop)
      : tests_(tests), options_(options), stop_(stop), queue_(tests, options, stop) {}

  std::vector<TestOutcome> Run() {
    for (;;) {
      while (const auto test = queue_.Next(children_.size())) Begin(*test);
      if (children_.empty()) return queue_.TakeOutcomes();
      ReadSome();
      for (Child& child : children_) Hurry(&child);
      std::erase_if(children_, [](const Child& child) { return child.descriptor < 0; });
    }
  }

 private:
  void Begin(size_t test) {
    int ends[2] = {};
    const bool piped = ::pipe2(ends, O_CLOEXEC) == 0;
    const pid_t self = ::getpid();
    const pid_t process = piped ? ::fork() : -1;
    if (process < 0) {
      queue_.NotStarted(test, std::strerror(errno));
      if (piped) {
        ::close(ends[0]);
        ::close(ends[1]);
      }
      return;
    }
    if (process == 0) {
      ::close(ends[0]);
      ::setpgid(0, 0);
      DieWithParent(self);
      WorkAndEnd(tests_[test].work, ends[1]);
    }
    ::close(ends[1]);
    // Also done by the child: whoever is first. Its group is killed with whatever it has started.
    ::setpgid(process, process);
    Child child;
    child.test = test;
    child.process = process;
    child.descriptor = ends[0];
    if (options_.timeout_s > 0) {
      child.killed_at = Clock::now() + std::chrono::seconds(options_.timeout_s);
    }
    children_.push_back(std::move(child));
  }

  // Waits for output of any child for a moment.
  void ReadSome() {
    std::vector<pollfd> readable;
    for (const Child& child : children_) readable.push_back({child.descriptor, POLLIN, 0});
    if (::poll(readable.data(), readable.size(), kLookMs) <= 0) return;
    for (size_t i = 0; i < children_.size(); ++i) {
      if (readable[i].revents == 0) continue;
      char buffer[65536];
      const ssize_t count = ::read(children_[i].descriptor, buffer, sizeof buffer);
      if (count == 0 || (count < 0 && errno != EINTR)) End(&children_[i]);
      if (count > 0) children_[i].text.append(buffer, static_cast<size_t>(count));
    }
  }

  // Stops a child that must end.
  void Hurry(Child* child) {
    if (child->descriptor < 0) return;
    if (stop_ && !child->told_to_stop) {
      child->told_to_stop = true;
      child->killed_at = Clock::now() + kTimeToEnd;
      ::kill(-child->process, SIGTERM);
    }
    if (child->killed_at && Clock::now() >= *child->killed_at) {
      ::kill(-child->process, SIGKILL);
      End(child);
    }
  }

  void End(Child* child) {
    TestOutcome& outcome = queue_.outcome(child->test);
    ::close(child->descriptor);
    child->descriptor = -1;
    int status = 0;
    while (::waitpid(child->process, &status, 0) < 0 && errno == EINTR) {
    }
    if (status == 0 && UnpackOutcome(child->text, &outcome)) return;
    if (child->told_to_stop) {
      queue_.Interrupted(child->test);
    } else if (child->killed_at && Clock::now() >= *child->killed_at) {
      outcome.failures.push_back(TookTooLong(options_.timeout_s));
    } else {
      outcome.failures.push_back(DescribeEnd(status));
    }
  }

  const std::vector<IsolatedTest>& tests_;
  const IsolationOptions& options_;
  const std::atomic<bool>& stop_;
  TestQueue queue_;
  std::vector<Child> children_;
};

}  // namespace

std::vector<TestOutcome> RunIsolated(const std::vector<IsolatedTest>& tests,
                                     const IsolationOptions& options,
                                     const std::atomic<bool>& stop) {
  return IsolatedRuns(tests, options, stop).Run();
}

}  // namespace oncard::tools
