#include "runtime/virtual_time.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace oncard::runtime {
namespace {

/// How long the first sleeper lets the other threads work before it looks again: short at first, so
/// that threads that hand over quickly cost little, then longer, so that a thread that computes is
/// not disturbed.
constexpr long kFirstLookNs = 20'000;
constexpr long kLastLookNs = 500'000;

/// Real sleep. The system call itself: the C library's functions may be replaced by ones that end
/// up here.
void RealSleep(long ns) {
  const timespec duration = {0, ns};
  ::syscall(SYS_nanosleep, &duration, nullptr);
}

/// A waiting thread, and how often it had been given the processor: as long as that number stays,
/// it has not run.
struct WaitingThread {
  std::string id;
  std::string switches;
  bool operator==(const WaitingThread&) const = default;
};

/// The rest of the line of /proc/.../status that begins with `key`.
std::string_view LineOf(std::string_view status, std::string_view key) {
  const size_t at = status.find(key);
  if (at == std::string_view::npos) return {};
  const std::string_view line = status.substr(at + key.size());
  return line.substr(0, line.find('\n'));
}

/// Appends a thread of this process when it waits; false when it does not.
bool AppendWaiting(const char* id, std::vector<WaitingThread>* waiting) {
  const std::string path = std::string("/proc/self/task/") + id + "/status";
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return true;  // it has just ended
  std::string text(4096, '\0');
  const ssize_t size = ::read(file, text.data(), text.size());
  ::close(file);
  const std::string_view status = std::string_view(text).substr(0, size < 0 ? 0 : size_t(size));
  if (status.empty()) return true;
  const std::string_view state = LineOf(status, "\nState:\t");
  const bool sleeps = state.starts_with('S') || state.starts_with('Z') || state.starts_with('X');
  waiting->push_back({id, std::string(LineOf(status, "\nvoluntary_ctxt_switches:\t"))});
  return sleeps;
}

/// The other threads of this process; false when one of them does not wait.
bool ListWaiting(std::vector<WaitingThread>* waiting) {
  DIR* folder = ::opendir("/proc/self/task");
  if (folder == nullptr) return true;
  const std::string own = std::to_string(::syscall(SYS_gettid));
  bool all_wait = true;
  while (const dirent* entry = ::readdir(folder)) {
    if (entry->d_name[0] == '.' || entry->d_name == own) continue;
    all_wait = AppendWaiting(entry->d_name, waiting);
    if (!all_wait) break;
  }
  ::closedir(folder);
  return all_wait;
}

}  // namespace

VirtualTime& VirtualTime::OfProcess() {
  // Never destroyed: other threads of the host may still sleep while the process exits.
  static VirtualTime& time = *new VirtualTime;
  return time;
}

int64_t VirtualTime::Pass(int64_t ns) {
  std::unique_lock lock(mutex_);
  const int64_t now = now_ns_ + ns;
  now_ns_ = now;
  const auto due = [&] { return !sleepers_.empty() && sleepers_.begin()->first <= now; };
  if (due()) {
    changed_.notify_all();
    changed_.wait(lock, [&] { return !due(); });
  }
  return now;
}

void VirtualTime::SleepUntil(int64_t deadline_ns) {
  std::unique_lock lock(mutex_);
  const Sleeper own = {deadline_ns, next_sleeper_++};
  sleepers_.insert(own);
  long look_ns = kFirstLookNs;
  while (now_ns_ < deadline_ns) {
    if (*sleepers_.begin() != own) {
      changed_.wait(lock);
      continue;
    }
    lock.unlock();
    const bool alone = others_wait_();
    if (!alone) {
      RealSleep(look_ns);
      look_ns = std::min(2 * look_ns, kLastLookNs);
    }
    lock.lock();
    if (alone && *sleepers_.begin() == own) now_ns_ = std::max(now_ns_.load(), deadline_ns);
  }
  sleepers_.erase(own);
  changed_.notify_all();
}

// Two looks: a thread that waited at both without having run in between waited all the time, so at
// the moment between the looks all of them waited at once.
bool VirtualTime::OtherThreadsWait() {
  std::vector<WaitingThread> first;
  if (!ListWaiting(&first)) return false;
  if (first.empty()) return true;
  std::vector<WaitingThread> second;
  return ListWaiting(&second) && first == second;
}

}  // namespace oncard::runtime
