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
constexpr size_t kKeptThreads = 40;
/// How often the threads are looked at while some run, end and begin in between.
constexpr int kLooksOfOneAnswer = 4;
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

std::string TaskFileOf(ThreadId id, const char* name) {
  return "/proc/self/task/" + std::to_string(id) + "/" + name;
}

/// The rest of the line that begins with `key`.
std::string_view LineOf(std::string_view status, std::string_view key) {
  const size_t at = status.find(key);
  if (at == std::string_view::npos) return {};
  const std::string_view line = status.substr(at + key.size());
  return line.substr(0, line.find('\n'));
}

/// The letters of threads that wait: asleep, or ended and not yet waited for. Others run, or wait
/// for a disk.
bool IsWaitingState(std::string_view state) {
  return state.starts_with('S') || state.starts_with('Z') || state.starts_with('X');
}

/// By what `stat` says: its number, its name in parentheses, which can contain any, and its state.
bool IsWaiting(std::string_view stat) {
  const size_t name_end = stat.rfind(") ");
  return name_end != std::string_view::npos && IsWaitingState(stat.substr(name_end + 2));
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
  for (const int file : {thread.state, thread.runs, thread.call}) {
    if (file >= 0) ::close(file);
  }
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

size_t WaitingThreads::CountKnown(const Known& known) {
  const auto others = std::ranges::count_if(
      left_out, [&](const auto& out) { return out != 0 && out != known.caller; });
  return 1 + known.asleep.size() + static_cast<size_t>(others);
}

void WaitingThreads::OpenFiles(Thread* thread) const {
  const auto open = [thread](const char* name) {
    return MoveToKept(::open(TaskFileOf(thread->id, name).c_str(), O_RDONLY | O_CLOEXEC));
  };
  if (counts_runs_) {
    thread->call = open("syscall");
    thread->runs = open("schedstat");
  }
  thread->state = open(counts_runs_ ? "stat" : "status");
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
      listed.emplace_back().id = id;
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
  } else if (const int opened = ::open(TaskFileOf(thread.id, name).c_str(), O_RDONLY | O_CLOEXEC);
             opened >= 0) {
    size = ::read(opened, text.data(), text.size());
    ::close(opened);
  }
  text.resize(size < 0 ? 0 : static_cast<size_t>(size));
  return text;
}

// A thread that was woken and has not yet run has slept where `syscall` says, and has run as often
// as before; only its state says that it waits no more. But a thread that is about to sleep has the
// state already, and goes on if it is woken now. So a thread is first seen asleep by `syscall`,
// which tells whether it has stopped running, between its runs and its state. It has slept on if it
// has the state later, and its runs, read last, are the same.
WaitingThreads::Answer WaitingThreads::LookAt(Thread* thread, bool in_slices, bool* slept_on) {
  ++work_.looks;
  if (!counts_runs_) return LookAtStatus(thread, in_slices, slept_on);
  std::string state = Read(*thread, thread->state, "stat");
  if (state.empty()) return std::nullopt;
  if (!IsWaiting(state)) return Waits::kNot;
  if (in_slices) return Waits::kForThreads;
  const std::string runs = Read(*thread, thread->runs, "schedstat");
  if (runs.empty()) return std::nullopt;
  if (runs == thread->asleep) return thread->wait;

  *slept_on = false;
  thread->asleep.clear();
  const std::string call = Read(*thread, thread->call, "syscall");
  state = Read(*thread, thread->state, "stat");
  if (call.empty() || state.empty()) return std::nullopt;
  if (call.starts_with("running") || !IsWaiting(state)) return Waits::kNot;
  thread->asleep = runs;
  thread->wait = WaitOf(call);
  return thread->wait;
}

WaitingThreads::Answer WaitingThreads::LookAtStatus(Thread* thread, bool in_slices,
                                                    bool* slept_on) {
  const std::string status = Read(*thread, thread->state, "status");
  if (status.empty()) return std::nullopt;
  if (!IsWaitingState(LineOf(status, "\nState:\t"))) return Waits::kNot;
  if (in_slices) return Waits::kForThreads;
  const std::string_view runs = LineOf(status, "\nvoluntary_ctxt_switches:\t");
  if (runs == thread->asleep) return thread->wait;
  *slept_on = false;
  thread->asleep = runs;
  return thread->wait;
}

WaitingThreads::Answer WaitingThreads::LookAtOthers(const Known& known, bool* slept_on) {
  Waits all = Waits::kForThreads;
  *slept_on = true;
  for (Thread& thread : threads_) {
    if (thread.id == known.caller || IsIn(known.asleep, thread.id) || IsLeftOut(thread.id)) {
      continue;
    }
    const Answer answer = LookAt(&thread, IsIn(known.in_slices, thread.id), slept_on);
    if (!answer || *answer == Waits::kNot) return answer;
    if (*answer == Waits::kForOutside) all = Waits::kForOutside;
  }
  return all;
}

// Threads that wait when each is looked at need not have waited at one instant: before it waited,
// one may have woken another, or have begun a thread that was not counted. But one that has slept
// on since an earlier look has waited all the time. If all have, and are as many as were counted in
// between, then they waited when they were counted, and there was nobody else. So the first look
// suffices where an earlier answer has seen them all asleep, and a second one is needed otherwise.
// A thread in slices may have run in between, but only from one slice to the next.
Waits WaitingThreads::OthersWait(std::span<const ThreadId> asleep,
                                 std::span<const ThreadId> in_slices) {
  const std::lock_guard lock(mutex_);
  const Known known = {asleep, in_slices, CallingThread()};
  bool one_ended = false;
  for (int look = 0; look < kLooksOfOneAnswer; ++look) {
    const size_t count = Count();
    if (count != 0 && count <= CountKnown(known)) return Waits::kForThreads;
    if (one_ended || threads_.size() != count) ListThreads();
    bool slept_on = true;
    const Answer answer = LookAtOthers(known, &slept_on);
    if (answer == Waits::kNot) return Waits::kNot;
    one_ended = !answer.has_value();
    const bool are_all = count == 0 || threads_.size() == count;
    if (answer && slept_on && are_all) return *answer;
  }
  return Waits::kNot;
}

}  // namespace oncard::runtime
