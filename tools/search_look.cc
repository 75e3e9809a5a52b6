#include "tools/search_look.h"

#include <fmt/core.h>

namespace oncard::tools {
namespace {

constexpr std::chrono::seconds kShown{1};
/// How often a search is saved: if the process is killed, at most this much is lost.
constexpr std::chrono::seconds kKept{60};

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
  if (const int64_t cases = progress.cases; cases > 0) {
    const int64_t present = progress.cases_done + 1;
    const Message of_cases =
        MakeMessage("case {0} of {1}: ", "第 {0} 种情形，共 {1} 种：", present, cases);
    text = {of_cases.en + text.en, of_cases.zh + text.zh};
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
      limits_(options.seconds, options.memory_mib, options.searches, progress) {
  progress_->estimates = options.shows;
}

bool SearchLook::Look() {
  if (!limits_.Look()) return false;
  if (progress_->out_of_time) return true;
  const auto now = Clock::now();
  if (options_.shows && now - shown_ >= kShown) {
    shown_ = now;
    const std::chrono::duration<double> passed = now - start_;
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
