#include "tools/isolation.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "tools/session.h"

namespace oncard::tools {
namespace {

/// How often the parent checks whether it must stop, and after how many checks a child must have
/// ended.
constexpr int kLookMs = 100;
constexpr int kLooksToEnd = 20;

// --- An outcome as text ----------------------------------------------------------------------

nlohmann::ordered_json Pack(const std::vector<Message>& messages) {
  nlohmann::ordered_json packed = nlohmann::ordered_json::array();
  for (const Message& message : messages) packed.push_back({message.en, message.zh});
  return packed;
}

std::vector<Message> Unpack(const nlohmann::ordered_json& packed) {
  std::vector<Message> messages;
  for (const nlohmann::ordered_json& message : packed)
    messages.push_back({message.at(0), message.at(1)});
  return messages;
}

std::string Pack(const TestOutcome& outcome) {
  const nlohmann::ordered_json packed = {{"failures", Pack(outcome.failures)},
                                         {"warnings", Pack(outcome.warnings)},
                                         {"time_ms", outcome.time_ms},
                                         {"statements", outcome.statements},
                                         {"interrupted", outcome.interrupted}};
  return JsonText(packed);
}

/// False if the text is incomplete.
bool Unpack(const std::string& text, TestOutcome* outcome) {
  const nlohmann::ordered_json packed = nlohmann::ordered_json::parse(text, nullptr, false);
  if (!packed.is_object()) return false;
  outcome->failures = Unpack(packed.at("failures"));
  outcome->warnings = Unpack(packed.at("warnings"));
  outcome->time_ms = packed.at("time_ms");
  outcome->statements = packed.at("statements");
  outcome->interrupted = packed.at("interrupted");
  return true;
}

// --- The child -------------------------------------------------------------------------------

[[noreturn]] void WorkAndEnd(const std::function<TestOutcome()>& work, int descriptor) {
  TestOutcome outcome;
  try {
    outcome = work();
  } catch (const std::exception& error) {
    outcome.failures.push_back(MakeMessage("internal error: {0}", "内部错误：{0}", error.what()));
  }
  const std::string text = Pack(outcome);
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) ::_exit(1);
    rest.remove_prefix(static_cast<size_t>(written));
  }
  ::_exit(0);
}

// --- The parent ------------------------------------------------------------------------------

/// Reads the child's output until it ends. True if the child was told to stop.
bool ReadAll(int descriptor, pid_t child, const std::atomic<bool>& stop, std::string* text) {
  int looks = 0;
  for (;;) {
    pollfd readable = {descriptor, POLLIN, 0};
    if (::poll(&readable, 1, kLookMs) > 0) {
      char buffer[4096];
      const ssize_t count = ::read(descriptor, buffer, sizeof buffer);
      if (count == 0 || (count < 0 && errno != EINTR)) return looks > 0;
      if (count > 0) text->append(buffer, static_cast<size_t>(count));
    }
    if (!stop) continue;
    if (looks == 0) ::kill(child, SIGTERM);
    if (++looks > kLooksToEnd) ::kill(child, SIGKILL);
  }
}

Message DescribeEnd(int status) {
  if (WIFSIGNALED(status)) {
    const char* name = ::strsignal(WTERMSIG(status));
    return MakeMessage("oncard itself crashed on this file ({0}): please report it",
                       "oncard 处理该文件时崩溃（{0}）：请报告此问题", name);
  }
  if (WEXITSTATUS(status) == kExitIncomplete) {
    return {"there was not enough memory for it", "内存不足，无法完成"};
  }
  return MakeMessage("oncard ended unexpectedly on this file (exit code {0}): please report it",
                     "oncard 处理该文件时意外结束（退出码 {0}）：请报告此问题",
                     WEXITSTATUS(status));
}

}  // namespace

TestOutcome RunIsolated(const std::string& path, const std::function<TestOutcome()>& work,
                        const std::atomic<bool>& stop) {
  TestOutcome outcome;
  outcome.path = path;
  int ends[2] = {};
  const bool piped = ::pipe2(ends, O_CLOEXEC) == 0;
  const pid_t child = piped ? ::fork() : -1;
  if (child < 0) {
    outcome.failures.push_back(MakeMessage("cannot start a process for it: {0}",
                                           "无法为其启动进程：{0}", std::strerror(errno)));
    if (piped) {
      ::close(ends[0]);
      ::close(ends[1]);
    }
    return outcome;
  }
  if (child == 0) {
    ::close(ends[0]);
    WorkAndEnd(work, ends[1]);
  }
  ::close(ends[1]);
  std::string text;
  const bool told = ReadAll(ends[0], child, stop, &text);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (status == 0 && Unpack(text, &outcome)) return outcome;
  outcome.interrupted = told;
  outcome.failures.push_back(told ? Message{"interrupted", "被中断"} : DescribeEnd(status));
  return outcome;
}

}  // namespace oncard::tools
