#include "runtime/host/waiting_threads.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <string_view>

namespace oncard::runtime {
namespace {

/// Files of more threads are not kept open: a process may have few descriptors.
constexpr size_t kKeptThreads = 64;
/// How often threads that end and begin during the look are listed anew.
constexpr int kListingsOfOneLook = 3;
/// A folder has two links besides those of its subfolders.
constexpr size_t kOwnLinks = 2;

/// Threads that do not belong to the host; 0: none.
std::array<std::atomic<ThreadId>, 8> left_out{};

bool IsIn(std::span<const ThreadId> threads, ThreadId id) {
  return std::find(threads.begin(), threads.end(), id) != threads.end();
}

bool IsLeftOut(ThreadId id) {
  return std::any_of(left_out.begin(), left_out.end(), [id](const auto& out) { return out == id; });
}

std::string PathOf(ThreadId id, const char* name) {
  return "/proc/self/task/" + std::to_string(id) + "/" + name;
}

/// The rest of the line that begins with `key`.
std::string_view LineOf(std::string_view status, std::string_view key) {
  const size_t at = status.find(key);
  if (at == std::string_view::npos) return {};
  const std::string_view line = status.substr(at + key.size());
  return line.substr(0, line.find('\n'));
}

/// The letters of threads that wait: asleep, or ended and not yet waited for.
bool IsWaiting(std::string_view state) {
  return state.starts_with('S') || state.starts_with('Z') || state.starts_with('X');
}

/// For what a thread waits that is asleep, by what `syscall` says of it.
Waits WaitOf(const std::string& call) {
  const long number = std::atol(call.c_str());
#ifdef SYS_futex_time64
  if (number == SYS_futex_time64) return Waits::kForThreads;
#endif
  return number == SYS_futex ? Waits::kForThreads : Waits::kForOutside;
}

}  // namespace

WaitingThreads& WaitingThreads::OfProcess() {
  // Never destroyed: other threads of the host may still sleep while the process exits.
  static WaitingThreads& threads = *new WaitingThreads;
  return threads;
}

WaitingThreads::~WaitingThreads() { CloseAll(); }

Waits HowOthersWait(std::span<const ThreadId> asleep, std::span<const ThreadId> in_slices) {
  return WaitingThreads::OfProcess().OthersWait(asleep, in_slices);
}

LeftOutThread::LeftOutThread() {
  for (auto& out : left_out) {
    ThreadId none = 0;
    if (out.compare_exchange_strong(none, CallingThread())) return;
  }
}

LeftOutThread::~LeftOutThread() {
  for (auto& out : left_out) {
    ThreadId own = CallingThread();
    out.compare_exchange_strong(own, 0);
  }
}

// Where the host has closed our descriptors, those with their numbers are its own.
void WaitingThreads::CloseAll() {
  if (folder_.Status()) {
    for (const Thread& thread : threads_) CloseFiles(thread);
  }
  threads_.clear();
  folder_.Close();
}

void WaitingThreads::CloseFiles(const Thread& thread) const {
  if (thread.call >= 0) ::close(thread.call);
  if (thread.runs >= 0) ::close(thread.runs);
}

void WaitingThreads::OpenFolder() {
  folder_.Reset(::open("/proc/self/task", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder_.Status()) return;
  // Kernels that do not count runs say "0 0 0".
  const int runs = ::open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC);
  char first = '0';
  counts_runs_ = runs >= 0 && ::read(runs, &first, 1) == 1 && first != '0';
  if (runs >= 0) ::close(runs);
}

size_t WaitingThreads::Count() {
  const pid_t process = CallingProcess();
  if (process != process_) {
    // A child after fork() has one thread, and the files of its parent.
    for (auto& out : left_out) {
      if (process_ != 0) out = 0;
    }
    process_ = process;
    CloseAll();
  }
  auto folder = folder_.Status();
  if (!folder) {
    CloseAll();
    OpenFolder();
    folder = folder_.Status();
  }
  return folder && folder->st_nlink > kOwnLinks ? folder->st_nlink - kOwnLinks : 0;
}

void WaitingThreads::OpenFiles(Thread* thread) const {
  const auto open = [thread](const char* name) {
    return MoveToKept(::open(PathOf(thread->id, name).c_str(), O_RDONLY | O_CLOEXEC));
  };
  if (counts_runs_) thread->call = open("syscall");
  thread->runs = open(counts_runs_ ? "schedstat" : "status");
}

void WaitingThreads::ListThreads() {
  ++work_.listings;
  std::vector<Thread> listed;
  DIR* folder = ::opendir("/proc/self/task");
  if (folder == nullptr) return;
  while (const dirent* entry = ::readdir(folder)) {
    if (entry->d_name[0] == '.') continue;
    const ThreadId id = std::atoi(entry->d_name);
    const auto known = std::find_if(threads_.begin(), threads_.end(),
                                    [id](const Thread& thread) { return thread.id == id; });
    if (known != threads_.end()) {
      listed.push_back(std::move(*known));
      threads_.erase(known);
    } else {
      listed.push_back({id, -1, -1, {}});
      if (listed.size() <= kKeptThreads) OpenFiles(&listed.back());
    }
  }
  ::closedir(folder);
  for (const Thread& ended : threads_) CloseFiles(ended);
  threads_ = std::move(listed);
}

/// The text of a kept file, or of one that is opened for this look; empty if the thread has ended.
std::string WaitingThreads::Read(const Thread& thread, int file, const char* name) const {
  std::string text(4096, '\0');
  ssize_t size = -1;
  if (file >= 0) {
    size = ::pread(file, text.data(), text.size(), 0);
  } else if (const int opened = ::open(PathOf(thread.id, name).c_str(), O_RDONLY | O_CLOEXEC);
             opened >= 0) {
    size = ::read(opened, text.data(), text.size());
    ::close(opened);
  }
  text.resize(size < 0 ? 0 : static_cast<size_t>(size));
  return text;
}

WaitingThreads::Answer WaitingThreads::LookAt(Thread* thread, bool in_slices, bool second) {
  ++work_.looks;
  std::string runs;
  bool waits = false;
  Waits wait = Waits::kForOutside;
  if (counts_runs_) {
    const std::string call = Read(*thread, thread->call, "syscall");
    if (call.empty()) return std::nullopt;
    if (call.starts_with("running")) return Waits::kNot;
    if (in_slices) return Waits::kForThreads;
    wait = WaitOf(call);
    runs = Read(*thread, thread->runs, "schedstat");
    if (runs.empty()) return std::nullopt;
    if (runs == thread->asleep) return wait;
    // What is not running can also wait for a disk. The name in parentheses can contain any.
    const std::string status = Read(*thread, -1, "stat");
    const size_t name_end = status.rfind(") ");
    if (name_end == std::string::npos) return std::nullopt;
    waits = IsWaiting(std::string_view(status).substr(name_end + 2));
  } else {
    const std::string status = Read(*thread, thread->runs, "status");
    if (status.empty()) return std::nullopt;
    waits = IsWaiting(LineOf(status, "\nState:\t"));
    if (waits && in_slices) return Waits::kForThreads;
    runs = LineOf(status, "\nvoluntary_ctxt_switches:\t");
    if (waits && runs == thread->asleep) return wait;
  }
  thread->asleep = waits ? runs : std::string();
  return waits && !second ? wait : Waits::kNot;
}

WaitingThreads::Answer WaitingThreads::LookAtOthers(const Known& known, bool second) {
  Waits all = Waits::kForThreads;
  for (Thread& thread : threads_) {
    if (thread.id == known.caller || IsIn(known.asleep, thread.id) || IsLeftOut(thread.id)) {
      continue;
    }
    const Answer answer = LookAt(&thread, IsIn(known.in_slices, thread.id), second);
    if (!answer || *answer == Waits::kNot) return answer;
    if (*answer == Waits::kForOutside) all = Waits::kForOutside;
  }
  return all;
}

// The threads are looked at twice: one that waits both times and has not run in between has waited
// all the time. So at the instant between the two all of them waited. A thread in slices may have
// run in between, but only from one slice to the next.
Waits WaitingThreads::OthersWait(std::span<const ThreadId> asleep,
                                 std::span<const ThreadId> in_slices) {
  const std::lock_guard lock(mutex_);
  const Known known = {asleep, in_slices, CallingThread()};
  const size_t count = Count();
  size_t known_count = asleep.size() + 1;
  for (const auto& out : left_out) {
    if (out != 0 && out != known.caller) ++known_count;
  }
  if (count != 0 && count <= known_count) return Waits::kForThreads;
  for (int listing = 0; listing < kListingsOfOneLook; ++listing) {
    if (listing > 0 || threads_.size() != count) ListThreads();
    Answer answer = LookAtOthers(known, false);
    if (!answer) continue;
    // The first of several may have been woken by the last. A single one waits now.
    if (*answer != Waits::kNot && count != known_count + 1) answer = LookAtOthers(known, true);
    if (answer) return *answer;
  }
  return Waits::kNot;
}

}  // namespace oncard::runtime
