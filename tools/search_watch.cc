#include "tools/search_watch.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>

#include "tools/memory_use.h"

namespace oncard::tools {
namespace {

constexpr std::chrono::seconds kShown{1};
/// How often the memory is looked at: a search takes up to half a gigabyte in a second.
constexpr std::chrono::milliseconds kLook{100};
constexpr int64_t kMiB = int64_t{1} << 20;
/// How often a search is saved: if the process is killed, at most this much is lost.
constexpr std::chrono::seconds kKept{60};
/// The search ends so much of the time limit before it: then a failure is made simpler, for so long
/// at most, and what is left of the search is saved.
constexpr double kReserved = 0.06;

/// The search that a signal stops.
std::atomic<explore::SearchProgress*> watched{nullptr};

extern "C" void StopSearch(int /*signal*/) {
  explore::SearchProgress* progress = watched.load();
  if (progress == nullptr) return;
  progress->interrupted = true;
  progress->stop = true;
}

Message ProgressText(const explore::SearchProgress& progress, double seconds) {
  const int64_t executions = progress.executions;
  const int64_t states = progress.states;
  Message text = MakeMessage("{0} executions", "{0} 次执行", executions);
  const double expected = progress.expected;
  if (expected > 0) {
    text.en += fmt::format(" of about {:.2g} (± {:.1g})", expected, progress.expected_error.load());
    text.zh += fmt::format("，共约 {:.2g}（± {:.1g}）", expected, progress.expected_error.load());
  }
  if (states > 0) {
    const Message of_states =
        MakeMessage("; {0} states, {1} on the frontier", "；{0} 个状态，边界 {1}", states,
                    progress.frontier.load());
    text.en += of_states.en;
    text.zh += of_states.zh;
  }
  text.en += fmt::format("; {:.2g} per second", static_cast<double>(executions + states) / seconds);
  text.zh += fmt::format("；每秒 {:.2g}", static_cast<double>(executions + states) / seconds);
  return text;
}

}  // namespace

SearchWatch::SearchWatch(const Invocation& invocation, const WatchOptions& options)
    : invocation_(invocation), options_(options) {
  progress_.estimates = options.shows;
  watched = &progress_;
  struct sigaction stops = {};
  stops.sa_handler = StopSearch;
  stops.sa_flags = static_cast<int>(SA_RESETHAND);
  for (size_t i = 0; i < kSignals.size(); ++i) {
    ::sigaction(kSignals[i], nullptr, &before_[i]);
    const bool ignored = before_[i].sa_handler == SIG_IGN;
    if (kSignals[i] != SIGHUP || !ignored) ::sigaction(kSignals[i], &stops, nullptr);
  }
  watching_ = std::thread([this] { Watch(); });
}

SearchWatch::~SearchWatch() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  watching_.join();
  for (size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before_[i], nullptr);
  watched = nullptr;
}

void SearchWatch::End(std::atomic<bool>* why) {
  *why = true;
  progress_.interrupted = true;
  progress_.stop = true;
}

int64_t SearchWatch::MemoryLimit() const {
  if (options_.memory_mib > 0) return options_.memory_mib * kMiB;
  const std::optional<int64_t> left = MemoryLeft();
  return left ? MemoryInUse() + *left / 2 / options_.searches : INT64_MAX;
}

void SearchWatch::Watch() {
  const int64_t memory = MemoryLimit();
  const auto start = std::chrono::steady_clock::now();
  const std::chrono::duration<double> given(options_.seconds);
  const std::chrono::duration<double> searched = given * (1 - kReserved);
  auto kept = start;
  auto shown = start;
  const auto next = [&]() -> std::chrono::duration<double> {
    if (options_.seconds == 0) return kLook;
    const auto end = progress_.out_of_time ? given : searched;
    const std::chrono::duration<double> left = start + end - std::chrono::steady_clock::now();
    return std::min<std::chrono::duration<double>>(left, kLook);
  };
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, next(), [this] { return over_; })) {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - start;
    if (progress_.out_of_time) {
      if (passed < given) continue;
      progress_.hurried = true;
      return;
    }
    if (options_.seconds > 0 && passed >= searched) {
      End(&progress_.out_of_time);
      continue;
    }
    if (!progress_.out_of_memory && MemoryInUse() > memory) End(&progress_.out_of_memory);
    if (options_.shows && now - shown >= kShown) {
      shown = now;
      PrintDiagnostics(options_.title + (options_.title.empty() ? "" : ": ") +
                       invocation_.Say(ProgressText(progress_, passed.count())) + '\n');
    }
    if (options_.pauses && now - kept >= kKept) {
      kept = now;
      progress_.pausing = true;
      progress_.stop = true;
    }
  }
}

}  // namespace oncard::tools
