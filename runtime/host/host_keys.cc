#include "runtime/host/host_keys.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "base/message.h"
#include "runtime/host/call_scope.h"
#include "runtime/host/host_scenario.h"
#include "runtime/host/host_system.h"
#include "runtime/host/host_time.h"
#include "runtime/host/terminal.h"

namespace oncard::runtime {
namespace {

/// How often a host may ask for a key after the last one. Once is normal: "press any key" at its
/// end.
constexpr int kReadsAfterEnd = 1000;

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
  return TerminalHasKey();
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
  ExitHost(kExitNoMoreKeys);
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

int HostKeys::ReadNext() { return scripted_ ? ReadScripted() : ReadTerminalKey(); }

}  // namespace oncard::runtime
