#include "runtime/host/virtual_time.h"

#include <dirent.h>
#include <fcntl.h>
#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/host/call_scope.h"

namespace oncard::runtime {
namespace {

/// How long the first sleeper lets the other threads run before it checks again: short at first, so
/// that threads that soon wait cost little time, then longer, so that a thread that computes is not
/// disturbed.
constexpr long kFirstLookNs = 20'000;
constexpr long kLastLookNs = 500'000;
/// Slices of waits with a deadline: of the one that ends first, and of the others, which only need
/// to notice in time when theirs is the first.
constexpr int64_t kFirstSliceNs = 200'000;
constexpr int64_t kOtherSliceNs = 1'000'000;

/// A thread that does not belong to the host; 0: there is none.
std::atomic<long> left_out{0};

/// Sleeps in real time. A direct system call: the C library's functions may be replaced by
/// functions that lead back here.
void RealSleep(long ns) {
  const timespec duration = {0, ns};
  ::syscall(SYS_nanosleep, &duration, nullptr);
}

/// A waiting thread, and how often it has given up the processor: while this number does not
/// change, the thread has not run.
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

/// Appends a thread of this process; false if it is not waiting.
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

/// Lists the other threads of this process, without the switch counts of those `in_slices`; false
/// if one of them is not waiting.
bool ListWaiting(std::span<const VirtualTime::ThreadId> in_slices,
                 std::vector<WaitingThread>* waiting) {
  DIR* folder = ::opendir("/proc/self/task");
  if (folder == nullptr) return true;
  const std::string own = std::to_string(::syscall(SYS_gettid));
  const std::string not_asked = std::to_string(left_out);
  bool all_wait = true;
  while (const dirent* entry = ::readdir(folder)) {
    if (entry->d_name[0] == '.' || entry->d_name == own || entry->d_name == not_asked) continue;
    const size_t count = waiting->size();
    all_wait = AppendWaiting(entry->d_name, waiting);
    if (!all_wait) break;
    const bool in_slice =
        std::find(in_slices.begin(), in_slices.end(), std::atoi(entry->d_name)) != in_slices.end();
    if (in_slice && waiting->size() > count) waiting->back().switches.clear();
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

int64_t VirtualTime::After(int64_t ns) const {
  const int64_t now = NowNs();
  return ns > kEndNs - now ? kEndNs : now + ns;
}

int64_t VirtualTime::Add(int64_t deadline_ns, ThreadId in_slices) {
  const int64_t number = next_number_++;
  sleepers_.insert({deadline_ns, number, in_slices});
  ++changes_;
  return number;
}

void VirtualTime::Remove(int64_t deadline_ns, int64_t number) {
  sleepers_.erase({deadline_ns, number, 0});
  ++changes_;
  NotifyAll();
}

void VirtualTime::NotifyAll() {
  changed_.fetch_add(1);
  if (waiting_ > 0) ::syscall(SYS_futex, &changed_, FUTEX_WAKE_PRIVATE, INT_MAX, nullptr);
}

void VirtualTime::WaitForChange(std::unique_lock<std::mutex>* lock, int seen) {
  ++waiting_;
  lock->unlock();
  ::syscall(SYS_futex, &changed_, FUTEX_WAIT_PRIVATE, seen, nullptr);
  lock->lock();
  --waiting_;
}

void VirtualTime::LeaveOutCallingThread() { left_out = ::syscall(SYS_gettid); }

int64_t VirtualTime::Pass(int64_t ns) {
  std::unique_lock lock(mutex_);
  const int64_t now = After(ns);
  now_ns_.store(now, std::memory_order_relaxed);
  if (!IsDue(now)) return now;
  NotifyAll();
  // A handler of a signal may have interrupted a wait of this thread, which cannot end before it.
  const auto own = static_cast<ThreadId>(::syscall(SYS_gettid));
  while (IsDue(now, own)) WaitForChange(&lock, changed_);
  return now;
}

bool VirtualTime::IsDue(int64_t now, ThreadId but_of) const {
  for (const Sleeper& sleeper : sleepers_) {
    if (sleeper.deadline_ns > now) return false;
    if (but_of == 0 || sleeper.in_slices != but_of) return true;
  }
  return false;
}

bool VirtualTime::IsAlone(std::unique_lock<std::mutex>* lock, int64_t number) {
  std::vector<ThreadId> in_slices;
  for (const Sleeper& sleeper : sleepers_) {
    if (sleeper.in_slices != 0 && sleeper.number != number) in_slices.push_back(sleeper.in_slices);
  }
  const int64_t changes = changes_;
  lock->unlock();
  const bool others_wait = others_wait_(in_slices);
  lock->lock();
  return others_wait && changes == changes_ && IsFirst(number);
}

int64_t VirtualTime::SleepUntil(int64_t deadline_ns) {
  std::unique_lock lock(mutex_);
  const int64_t number = Add(deadline_ns, 0);
  long look_ns = kFirstLookNs;
  const WakingSignals wake(&changed_);
  while (now_ns_ < deadline_ns) {
    const int seen = changed_;
    if (CallScope::HoldsSignal()) break;
    if (!IsFirst(number)) {
      WaitForChange(&lock, seen);
    } else if (IsAlone(&lock, number)) {
      now_ns_ = std::max(now_ns_.load(), deadline_ns);
    } else if (now_ns_ < deadline_ns) {
      lock.unlock();
      RealSleep(look_ns);
      look_ns = std::min(2 * look_ns, kLastLookNs);
      lock.lock();
    }
  }
  Remove(deadline_ns, number);
  return std::max(deadline_ns - now_ns_, int64_t{0});
}

VirtualTime::Wait VirtualTime::BeginWait(int64_t deadline_ns) {
  const std::lock_guard lock(mutex_);
  return {deadline_ns, Add(deadline_ns, static_cast<ThreadId>(::syscall(SYS_gettid)))};
}

int64_t VirtualTime::NextSliceNs(const Wait& wait) {
  std::unique_lock lock(mutex_);
  if (now_ns_ >= wait.deadline_ns) return 0;
  if (!IsFirst(wait.number)) return kOtherSliceNs;
  return IsAlone(&lock, wait.number) || now_ns_ >= wait.deadline_ns ? 0 : kFirstSliceNs;
}

void VirtualTime::EndWait(const Wait& wait, bool expired) {
  const std::lock_guard lock(mutex_);
  if (expired) now_ns_ = std::max(now_ns_.load(), wait.deadline_ns);
  Remove(wait.deadline_ns, wait.number);
}

void VirtualTime::BecomeChild() {
  sleepers_.clear();
  ++changes_;
  waiting_ = 0;
  mutex_.unlock();
}

// The threads are examined twice: one that waits both times and has not run in between has waited
// all the time. So at the instant between the two all of them waited. A thread in slices may have
// run in between, but only from one slice to the next.
bool VirtualTime::OtherThreadsWait(std::span<const ThreadId> in_slices) {
  std::vector<WaitingThread> first;
  if (!ListWaiting(in_slices, &first)) return false;
  if (first.empty()) return true;
  std::vector<WaitingThread> second;
  return ListWaiting(in_slices, &second) && first == second;
}

}  // namespace oncard::runtime
