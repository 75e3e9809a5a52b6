#include "tools/search_watch.h"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>

namespace oncard::tools {
namespace {

constexpr std::chrono::seconds kShown{1};

/// Of the search that Ctrl-C ends.
std::atomic<std::atomic<bool>*> stop_of_search{nullptr};

extern "C" void StopSearch(int /*signal*/) {
  std::atomic<bool>* stop = stop_of_search.load();
  if (stop != nullptr) stop->store(true);
  static_cast<void>(std::signal(SIGINT, SIG_DFL));
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

SearchWatch::SearchWatch(const Session& session, bool shows) : session_(session) {
  progress_.estimates = shows;
  stop_of_search = &progress_.stop;
  static_cast<void>(std::signal(SIGINT, StopSearch));
  if (shows) showing_ = std::thread([this] { Show(); });
}

SearchWatch::~SearchWatch() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  if (showing_.joinable()) showing_.join();
  static_cast<void>(std::signal(SIGINT, SIG_DFL));
  stop_of_search = nullptr;
}

void SearchWatch::Show() {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, kShown, [this] { return over_; })) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    PrintDiagnostics(session_.Say(ProgressText(progress_, passed.count())) + '\n');
  }
}

}  // namespace oncard::tools
