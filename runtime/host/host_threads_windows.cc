#include "runtime/host/host_threads_windows.h"

#include <algorithm>
#include <mutex>
#include <span>
#include <vector>

#include "runtime/host/thread_waits.h"

namespace oncard::runtime {
namespace {

/// How often, in real time, those who wait look for changes that nobody has told us.
constexpr ULONGLONG kLookMs = 5;

struct HostThread {
  ThreadId id = 0;
  HANDLE handle = nullptr;  ///< is set when the thread has ended
  bool waits_for_outside = false;
};

struct HostThreads {
  std::mutex mutex;  // guards what follows
  std::vector<HostThread> threads;
  ULONGLONG last_look_ms = 0;

  static HostThreads& OfProcess() {
    // Never destroyed: other threads of the host may still run while the process exits.
    static HostThreads& threads = *new HostThreads;
    return threads;
  }

  HostThread* Find(ThreadId id) {
    const auto found = std::ranges::find(threads, id, &HostThread::id);
    return found == threads.end() ? nullptr : &*found;
  }

  void Remove(ThreadId id) {
    const auto found = std::ranges::find(threads, id, &HostThread::id);
    if (found == threads.end()) return;
    if (found->handle != nullptr) ::CloseHandle(found->handle);
    threads.erase(found);
  }

  /// Forgets the threads that have ended; true if there were any.
  bool RemoveEnded() {
    return std::erase_if(threads, [](const HostThread& thread) {
             const bool ended = thread.handle != nullptr &&
                                ::WaitForSingleObject(thread.handle, 0) == WAIT_OBJECT_0;
             if (ended) ::CloseHandle(thread.handle);
             return ended;
           }) > 0;
  }

  bool IsTimeToLook() {
    if (!handle_word.has_waiters() && !lock_word.has_waiters()) return false;
    const ULONGLONG now_ms = ::GetTickCount64();
    if (now_ms - last_look_ms < kLookMs) return false;
    last_look_ms = now_ms;
    return true;
  }
};

constinit thread_local bool enrolled = false;

bool IsIn(std::span<const ThreadId> threads, ThreadId id) {
  return std::ranges::find(threads, id) != threads.end();
}

void SetWaitsForOutside(bool waits) {
  HostThreads& all = HostThreads::OfProcess();
  const std::lock_guard lock(all.mutex);
  if (HostThread* const own = all.Find(CallingThread())) own->waits_for_outside = waits;
}

}  // namespace

void EnrolThread() {
  if (enrolled) return;
  enrolled = true;
  EnrolThread(::GetCurrentThreadId());
}

void EnrolThread(DWORD thread) {
  HostThreads& all = HostThreads::OfProcess();
  const auto id = static_cast<ThreadId>(thread);
  const std::lock_guard lock(all.mutex);
  // The number of a thread that has ended may be used again.
  all.RemoveEnded();
  if (all.Find(id) == nullptr) {
    all.threads.push_back({id, ::OpenThread(SYNCHRONIZE, FALSE, thread), false});
  }
}

constinit WaitWord handle_word;
constinit WaitWord lock_word;

void WaitWord::Change() {
  ++changes_;
  if (has_waiters()) VirtualTime::OfProcess().Wake(changes_, true);
}

VirtualTime::Woken WaitWord::SleepUntilChange(int seen, int64_t deadline_ns) {
  return VirtualTime::OfProcess().SleepOn(changes_, seen, deadline_ns);
}

WaitsForOutside::WaitsForOutside() { SetWaitsForOutside(true); }
WaitsForOutside::~WaitsForOutside() { SetWaitsForOutside(false); }

// A thread asleep in virtual time waits, and all else works. The end of a thread may end a wait.
Waits HowOthersWait(std::span<const ThreadId> asleep, std::span<const ThreadId> in_slices) {
  HostThreads& all = HostThreads::OfProcess();
  bool works = false;
  bool for_outside = false;
  bool changed = false;
  {
    const std::lock_guard lock(all.mutex);
    for (const HostThread& thread : all.threads) {
      if (thread.id == CallingThread() || IsIn(asleep, thread.id) || IsIn(in_slices, thread.id)) {
        continue;
      }
      works = works || !thread.waits_for_outside;
      for_outside = for_outside || thread.waits_for_outside;
    }
    changed = (works && all.RemoveEnded()) || all.IsTimeToLook();
  }
  if (changed) {
    handle_word.Change();
    lock_word.Change();
  }
  if (works || changed) return Waits::kNot;
  return for_outside ? Waits::kForOutside : Waits::kForThreads;
}

LeftOutThread::LeftOutThread() {
  HostThreads& all = HostThreads::OfProcess();
  const std::lock_guard lock(all.mutex);
  all.Remove(CallingThread());
}

LeftOutThread::~LeftOutThread() { EnrolThread(::GetCurrentThreadId()); }

}  // namespace oncard::runtime
