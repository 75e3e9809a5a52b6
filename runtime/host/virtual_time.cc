#include "runtime/host/virtual_time.h"

#include <algorithm>
#include <vector>

#include "runtime/host/call_scope.h"
#include "runtime/host/calling_thread.h"
#include "runtime/host/system_waits.h"

namespace oncard::runtime {
namespace {

/// How long the helper lets the other threads run before it looks again: short at first, so that
/// threads that soon wait cost little time, then longer, so that a thread that computes is not
/// disturbed.
constexpr int64_t kFirstLookNs = 20'000;
constexpr int64_t kLastLookNs = 500'000;
/// Slices of waits with a deadline: of the one that ends first, and of the others, which only need
/// to notice in time when theirs is the first.
constexpr int64_t kFirstSliceNs = 200'000;
constexpr int64_t kOtherSliceNs = 1'000'000;

void ChangeAndWake(std::atomic<int>* word) {
  word->fetch_add(1);
  WakeAll(word);
}

}  // namespace

VirtualTime& VirtualTime::OfProcess() {
  // Never destroyed: other threads of the host may still sleep while the process exits.
  static VirtualTime& time = *new VirtualTime;
  return time;
}

VirtualTime::~VirtualTime() {
  {
    const std::lock_guard lock(mutex_);
    if (helped_process_ != CallingProcess()) return;
    ends_ = true;
    ChangeAndWake(&helper_calls_);
  }
  ::pthread_join(helper_, nullptr);
}

// --- Time ----------------------------------------------------------------------------------------

int64_t VirtualTime::After(int64_t ns) const {
  const int64_t now = NowNs();
  return ns > kEndNs - now ? kEndNs : now + ns;
}

void VirtualTime::AdvanceTo(int64_t ns) {
  int64_t now = now_ns_;
  while (now < ns && !now_ns_.compare_exchange_weak(now, ns)) {
  }
}

// A sleeper first shows its deadline and then looks at the time, and a thread that lets time pass
// does so before it looks at the deadline: one of them sees the other without the lock.
int64_t VirtualTime::Pass(int64_t ns) {
  int64_t before = now_ns_;
  int64_t now = 0;
  do {
    now = ns > kEndNs - before ? kEndNs : before + ns;
  } while (!now_ns_.compare_exchange_weak(before, now));
  if (now < first_deadline_ns_ || acting_ == CallingThread()) return now;

  std::unique_lock<std::mutex> lock = Enter();
  MarkInterrupted(CallingThread());
  WakeDue();
  ++passing_;
  while (IsPassingSomeone(now)) {
    const int seen = gone_;
    lock.unlock();
    WaitFor(&gone_, seen);
    lock = Enter();
  }
  --passing_;
  return now;
}

bool VirtualTime::IsPassingSomeone(int64_t now) const {
  if (going_ > 0) return true;
  for (const Sleeper& sleeper : sleepers_) {
    if (sleeper.deadline_ns > now) return false;
    if (!sleeper.interrupted) return true;
  }
  return false;
}

void VirtualTime::TellPassing() {
  if (passing_ > 0) ChangeAndWake(&gone_);
}

// A thread that waits for the lock, or was woken and has not gone on, looks asleep.
std::unique_lock<std::mutex> VirtualTime::Enter() {
  ++entering_;
  std::unique_lock lock(mutex_);
  --entering_;
  ++visits_;
  return lock;
}

// --- Sleepers ------------------------------------------------------------------------------------

void VirtualTime::Add(const Sleeper& sleeper) {
  MarkInterrupted(sleeper.thread);
  sleepers_.insert(sleeper);
  ++changes_;
  first_deadline_ns_ = sleepers_.begin()->deadline_ns;
}

void VirtualTime::Remove(int64_t deadline_ns, int64_t number) {
  sleepers_.erase({deadline_ns, number});
  ++changes_;
  first_deadline_ns_ = sleepers_.empty() ? INT64_MAX : sleepers_.begin()->deadline_ns;
  TellPassing();
}

// A thread that begins something during a wait is in a handler that has interrupted it: the wait
// cannot end before the handler, and others do not wait for it.
void VirtualTime::MarkInterrupted(ThreadId thread) {
  bool any = false;
  for (const Sleeper& sleeper : sleepers_) {
    if (sleeper.thread == thread && !sleeper.interrupted) sleeper.interrupted = any = true;
  }
  if (any) TellPassing();
}

const VirtualTime::Sleeper* VirtualTime::First() const {
  const auto first = std::find_if(sleepers_.begin(), sleepers_.end(),
                                  [](const Sleeper& sleeper) { return !sleeper.interrupted; });
  return first == sleepers_.end() ? nullptr : &*first;
}

bool VirtualTime::WakeDue() {
  const int64_t now = now_ns_;
  if (now < first_deadline_ns_) return false;
  bool any = false;
  for (auto sleeper = sleepers_.begin();
       sleeper != sleepers_.end() && sleeper->deadline_ns <= now;) {
    const Sleeper due = *sleeper++;
    if (due.bed == nullptr) continue;
    WakeOne(due, Woken::kAtDeadline);
    any = true;
  }
  return any;
}

void VirtualTime::WakeOne(const Sleeper& sleeper, Woken how) {
  Bed* const bed = sleeper.bed;
  const bool is_own = sleeper.thread == CallingThread();
  Remove(sleeper.deadline_ns, sleeper.number);
  bed->woken = true;
  bed->how = how;
  if (is_own) return;
  bed->is_going = true;
  ++going_;
  ChangeAndWake(&bed->changes);
}

void VirtualTime::Wake(const std::atomic<int>& word, bool all) {
  const std::unique_lock<std::mutex> lock = Enter();
  // In the order in which they came, whatever their deadlines.
  for (;;) {
    const Sleeper* next = nullptr;
    for (const Sleeper& sleeper : sleepers_) {
      if (sleeper.bed == nullptr || sleeper.bed->word != &word) continue;
      if (next == nullptr || sleeper.number < next->number) next = &sleeper;
    }
    if (next == nullptr) return;
    WakeOne(Sleeper(*next), Woken::kByThread);
    if (!all) return;
  }
}

void VirtualTime::WakeFirst() {
  const std::unique_lock<std::mutex> lock = Enter();
  const auto first = std::ranges::find_if(sleepers_, [](const Sleeper& sleeper) {
    return sleeper.bed != nullptr && !sleeper.interrupted;
  });
  if (first != sleepers_.end()) WakeOne(Sleeper(*first), Woken::kByThread);
}

void VirtualTime::ListenTo(WakeUps* source) {
  const std::unique_lock<std::mutex> lock = Enter();
  source_ = source;
}

Waits VirtualTime::AskOthers(std::unique_lock<std::mutex>* lock) {
  if (going_ > 0) return Waits::kNot;
  const ThreadId own = CallingThread();
  std::vector<ThreadId> asleep;
  std::vector<ThreadId> in_slices;
  for (const Sleeper& sleeper : sleepers_) {
    // Who has interrupted a wait runs.
    if (sleeper.thread == own || sleeper.interrupted) continue;
    (sleeper.bed ? asleep : in_slices).push_back(sleeper.thread);
  }
  const int64_t changes = changes_;
  const int64_t visits = visits_;
  lock->unlock();
  const Waits others = others_wait_(asleep, in_slices);
  lock->lock();
  const bool undisturbed = changes == changes_ && visits == visits_ && entering_ == 0;
  return undisturbed ? others : Waits::kNot;
}

bool VirtualTime::Jump(std::unique_lock<std::mutex>* lock) {
  if (WakeDue()) return true;
  const Sleeper* first = First();
  if (first == nullptr || first->bed == nullptr || acting_ != 0) return false;
  const Waits others = AskOthers(lock);
  if (others == Waits::kNot) return false;
  if (source_ != nullptr) {
    if (!FollowSource(lock)) return true;
    first = First();
  }
  if (first->deadline_ns == kNeverNs) return others == Waits::kForThreads && GiveUpWaiting();
  AdvanceTo(first->deadline_ns);
  return WakeDue();
}

bool VirtualTime::FollowSource(std::unique_lock<std::mutex>* lock) {
  const int64_t visits = visits_;
  acting_ = CallingThread();
  bool alone = true;
  while (alone) {
    lock->unlock();
    const int64_t next_ns = source_->NextNs();
    lock->lock();
    const Sleeper* const first = First();
    alone = visits == visits_ && entering_ == 0 && first != nullptr;
    if (!alone || first->deadline_ns <= next_ns) break;
    AdvanceTo(next_ns);
    lock->unlock();
    source_->Act();
    lock->lock();
    alone = visits == visits_ && entering_ == 0;
  }
  acting_ = 0;
  return alone;
}

bool VirtualTime::GiveUpWaiting() {
  bool any = false;
  for (auto sleeper = sleepers_.begin(); sleeper != sleepers_.end();) {
    const Sleeper endless = *sleeper++;
    if (endless.bed == nullptr || endless.deadline_ns != kNeverNs) continue;
    WakeOne(endless, Woken::kNever);
    any = true;
  }
  return any;
}

int64_t VirtualTime::SleepUntil(int64_t deadline_ns) {
  Bed bed;
  return Sleep(deadline_ns, &bed);
}

VirtualTime::Woken VirtualTime::SleepOn(const std::atomic<int>& word, int value,
                                        int64_t deadline_ns) {
  Bed bed;
  bed.word = &word;
  bed.value = value;
  const int64_t left_ns = Sleep(deadline_ns, &bed);
  return left_ns > 0 && bed.how == Woken::kAtDeadline ? Woken::kByThread : bed.how;
}

int64_t VirtualTime::Sleep(int64_t deadline_ns, Bed* own_bed) {
  Bed& bed = *own_bed;
  const WakingSignals wake(&bed.changes);
  const auto left = [&] { return std::max(deadline_ns - now_ns_, int64_t{0}); };
  std::unique_lock<std::mutex> lock = Enter();
  if (bed.word != nullptr && *bed.word != bed.value) return left();
  const Sleeper own = {deadline_ns, next_number_++, CallingThread(), &bed};
  Add(own);
  while (!bed.woken) {
    const int seen = bed.changes;
    if (CallScope::HoldsSignal()) {
      Remove(own.deadline_ns, own.number);
      return left();
    }
    Jump(&lock);
    if (bed.woken) break;
    const bool helped = CallHelper();
    lock.unlock();
    if (helped) {
      WaitFor(&bed.changes, seen);
    } else {
      WaitFor(&bed.changes, seen, kLastLookNs);
    }
    lock = Enter();
  }
  if (bed.is_going && --going_ == 0) TellPassing();
  return bed.how == Woken::kAtDeadline ? 0 : left();
}

VirtualTime::Wait VirtualTime::BeginWait(int64_t deadline_ns) {
  const std::unique_lock<std::mutex> lock = Enter();
  const Sleeper own = {deadline_ns, next_number_++, CallingThread(), nullptr};
  Add(own);
  return {deadline_ns, own.number};
}

int64_t VirtualTime::NextSliceNs(const Wait& wait) {
  std::unique_lock<std::mutex> lock = Enter();
  const auto own = sleepers_.find({wait.deadline_ns, wait.number});
  if (own != sleepers_.end()) {
    own->interrupted = false;
  } else {
    // A handler has called fork(), and the child goes on with the wait.
    Add({wait.deadline_ns, wait.number, CallingThread(), nullptr});
  }
  if (now_ns_ >= wait.deadline_ns) return 0;
  if (First()->number != wait.number) return kOtherSliceNs;
  if (acting_ == 0 && AskOthers(&lock) != Waits::kNot &&
      (source_ == nullptr || FollowSource(&lock))) {
    return 0;
  }
  return now_ns_ >= wait.deadline_ns ? 0 : kFirstSliceNs;
}

void VirtualTime::EndWait(const Wait& wait, bool expired) {
  const std::unique_lock<std::mutex> lock = Enter();
  if (expired) AdvanceTo(wait.deadline_ns);
  Remove(wait.deadline_ns, wait.number);
  WakeDue();
}

void VirtualTime::LetOthersPass() {
  const std::unique_lock<std::mutex> lock = Enter();
  MarkInterrupted(CallingThread());
}

// --- The helper ----------------------------------------------------------------------------------

bool VirtualTime::CallHelper() {
  if (helped_process_ != CallingProcess()) return StartHelper();
  if (helper_rests_) ChangeAndWake(&helper_calls_);
  helper_rests_ = false;
  return true;
}

bool VirtualTime::StartHelper() {
  const auto help = [](void* time) -> void* {
    static_cast<VirtualTime*>(time)->Help();
    return nullptr;
  };
  helper_rests_ = false;
  const bool started = StartOwnThread(&helper_, help, this);
  if (started) helped_process_ = CallingProcess();
  return started;
}

void VirtualTime::Help() {
  const LeftOutThread helper;
  std::unique_lock lock(mutex_);
  int64_t look_ns = kFirstLookNs;
  while (!ends_) {
    const int64_t seen = changes_;
    const int calls = helper_calls_;
    helper_rests_ = sleepers_.empty();
    const bool rests = helper_rests_;
    lock.unlock();
    if (rests) {
      WaitFor(&helper_calls_, calls);
    } else {
      RealSleep(look_ns);
    }
    lock.lock();
    look_ns = std::min(2 * look_ns, kLastLookNs);
    if (rests || (changes_ == seen && Jump(&lock))) look_ns = kFirstLookNs;
  }
}

// --- fork() --------------------------------------------------------------------------------------

void VirtualTime::LockForFork() { Enter().release(); }

void VirtualTime::UnlockAfterFork() { mutex_.unlock(); }

void VirtualTime::BecomeChild() {
  sleepers_.clear();
  first_deadline_ns_ = INT64_MAX;
  ++changes_;
  acting_ = 0;
  entering_ = 0;
  going_ = 0;
  passing_ = 0;
  UnlockAfterFork();
}

}  // namespace oncard::runtime
