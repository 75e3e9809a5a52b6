#include "runtime/host/host_keys.h"

#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "base/message.h"
#include "runtime/host/call_scope.h"
#include "runtime/host/host_scenario.h"
#include "runtime/host/host_time.h"

namespace oncard::runtime {
namespace {

/// How often a host may ask for a key after the last one. Once is normal: "press any key" at its
/// end.
constexpr int kReadsAfterEnd = 1000;

/// Switches the terminal to single keys without echo, from the first read to the end of the
/// process.
class RawTerminal {
 public:
  RawTerminal() {
    if (::tcgetattr(STDIN_FILENO, &before_) != 0) return;
    changed_ = true;
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
  ~RawTerminal() {
    if (changed_) ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }

 private:
  termios before_{};
  bool changed_ = false;
};

void OpenTerminal() { static const RawTerminal terminal; }

/// The keys from the environment and from the scenario.
std::vector<KeyPress> ScriptOfProcess() {
  const char* setting = std::getenv("ONCARD_KEYS");
  auto script = ParseKeyScript(setting == nullptr ? "" : setting);
  std::vector<KeyPress> presses;
  if (script.ok()) {
    presses = std::move(script).value();
  } else {
    std::fprintf(stderr, "oncard: %s\n",
                 script.error().message.In(LanguageFromEnvironment()).c_str());
  }
  const auto scenario = ScenarioFromEnvironment();
  if (scenario.ok() && scenario.value()) {
    const auto& keys = scenario.value()->keys;
    presses.insert(presses.end(), keys.begin(), keys.end());
  }
  return presses;
}

}  // namespace

HostKeys::HostKeys(std::vector<KeyPress> script) : scripted_(!script.empty()) {
  std::stable_sort(script.begin(), script.end(),
                   [](const KeyPress& a, const KeyPress& b) { return a.at_us < b.at_us; });
  for (const KeyPress& press : script) {
    for (const char character : press.text) {
      keys_.push_back({press.at_us * 1000, static_cast<unsigned char>(character)});
    }
  }
}

HostKeys& HostKeys::OfProcess() {
  // Never destroyed: other threads of the host may still read keys while the process exits.
  static HostKeys& keys = *new HostKeys(ScriptOfProcess());
  return keys;
}

bool HostKeys::Hit() {
  const int64_t now_ns = LookAtHostTimeNs();
  if (scripted_) {
    const std::lock_guard lock(mutex_);
    return next_ < keys_.size() && keys_[next_].at_ns <= now_ns;
  }
  OpenTerminal();
  // Not poll(), which would report the end of the input as a key.
  int available = 0;
  return ::ioctl(STDIN_FILENO, FIONREAD, &available) == 0 && available > 0;
}

int HostKeys::Read() {
  const int key = ReadNext();
  if (key >= 0) return key;
  {
    const CallScope scope;
    const std::lock_guard lock(mutex_);
    if (++reads_after_end_ < kReadsAfterEnd) return key;
  }
  const Message message = MakeMessage(
      "the host has asked {0} times for a key after the last one; add the keys that make it end "
      "(--keys, ONCARD_KEYS or the scenario)",
      "最后一个按键之后主机程序又等待了 {0} 次按键；请给出使其结束的按键（--keys、ONCARD_KEYS "
      "或场景文件）",
      kReadsAfterEnd);
  std::fprintf(stderr, "oncard: %s\n", message.In(LanguageFromEnvironment()).c_str());
  std::exit(kExitNoMoreKeys);
}

int HostKeys::ReadScripted() {
  Key key;
  int64_t left_ns = 0;
  {
    const CallScope scope;
    {
      const std::lock_guard lock(mutex_);
      if (next_ == keys_.size()) return -1;
      key = keys_[next_++];
    }
    // Without the lock: time may have to wait for a thread whose handler asks for keys.
    left_ns = key.at_ns - LookAtHostTimeNs();
  }
  do {  // a signal may end a sleep
    left_ns = SleepHostNs(left_ns);
  } while (left_ns > 0);
  return key.character;
}

int HostKeys::ReadNext() {
  if (scripted_) return ReadScripted();
  OpenTerminal();
  std::fflush(stdout);
  unsigned char character = 0;
  return ::read(STDIN_FILENO, &character, 1) == 1 ? character : -1;
}

}  // namespace oncard::runtime
