#include "tools/search_look.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

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

SearchLook::SearchLook(const Invocation& invocation, const WatchOptions& options,
                       explore::SearchProgress* progress)
    : invocation_(invocation),
      options_(options),
      progress_(progress),
      memory_(MemoryLimit()),
      given_(options.seconds),
      searched_(given_ * (1 - kReserved)) {
  progress_->estimates = options.shows;
}

int64_t SearchLook::MemoryLimit() const {
  if (options_.memory_mib > 0) return options_.memory_mib * kMiB;
  const std::optional<int64_t> left = MemoryLeft();
  return left ? MemoryInUse() + *left / 2 / options_.searches : INT64_MAX;
}

void SearchLook::End(std::atomic<bool>* why) {
  *why = true;
  progress_->interrupted = true;
  progress_->stop = true;
}

std::chrono::duration<double> SearchLook::Next() const {
  if (options_.seconds == 0) return kLook;
  const auto end = progress_->out_of_time ? given_ : searched_;
  const std::chrono::duration<double> left = start_ + end - Clock::now();
  return std::min<std::chrono::duration<double>>(left, kLook);
}

bool SearchLook::Look() {
  const auto now = Clock::now();
  const std::chrono::duration<double> passed = now - start_;
  if (progress_->out_of_time) {
    if (passed < given_) return true;
    progress_->hurried = true;
    return false;
  }
  if (options_.seconds > 0 && passed >= searched_) {
    End(&progress_->out_of_time);
    return true;
  }
  if (!progress_->out_of_memory && MemoryInUse() > memory_) End(&progress_->out_of_memory);
  if (options_.shows && now - shown_ >= kShown) {
    shown_ = now;
    PrintDiagnostics(options_.title + (options_.title.empty() ? "" : ": ") +
                     invocation_.Say(ProgressText(*progress_, passed.count())) + '\n');
  }
  if (options_.pauses && now - kept_ >= kKept) {
    kept_ = now;
    progress_->pausing = true;
    progress_->stop = true;
  }
  return true;
}

}  // namespace oncard::tools
