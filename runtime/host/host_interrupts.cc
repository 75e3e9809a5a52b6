#include "runtime/host/host_interrupts.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/message.h"
#include "runtime/host/call_scope.h"
#include "runtime/host/card_table.h"
#include "runtime/host/library.h"

namespace oncard::runtime {

HostInterrupts& HostInterrupts::OfProcess() {
  // Never destroyed: other threads of the host may still wait while the process exits.
  static HostInterrupts& interrupts = *new HostInterrupts;
  return interrupts;
}

void HostInterrupts::Listen() {
  static std::atomic<bool> listens = false;
  if (!listens.exchange(true)) VirtualTime::OfProcess().ListenTo(this);
}

void HostInterrupts::Answer(int card, InterruptAnswer answer) {
  const std::lock_guard lock(mutex_);
  Answered& answered = cards_[static_cast<size_t>(card)];
  const auto count = [&] { return answered.answer.handler || answered.answer.event ? 1 : 0; };
  answered_ -= count();
  answered.answer = std::move(answer);
  answered_ += count();
  if (std::exchange(answered.pending, false)) --pending_;
  if (Awaited()) Listen();
}

InterruptAnswer HostInterrupts::AnswerOf(int card) {
  const std::lock_guard lock(mutex_);
  return cards_[static_cast<size_t>(card)].answer;
}

void HostInterrupts::Enable() {
  disabled_ = false;
  Come();
}

void ReportHopelessWait() {
  static std::atomic<bool> said = false;
  if (said.exchange(true)) return;
  const Message message = MakeMessage(
      "every thread waits for an interrupt that cannot come: the wait fails after {} s",
      "所有线程都在等待不可能到来的中断：{} s 后等待失败", kNothingComesNs / 1'000'000'000);
  std::fprintf(stderr, "oncard: %s\n", message.In(LanguageFromEnvironment()).c_str());
}

// --- Cards ---------------------------------------------------------------------------------------

template <typename Visit>
void HostInterrupts::VisitAnswered(const Visit& visit) {
  for (int card = 0; card < kCardCount; ++card) {
    const InterruptAnswer answer = AnswerOf(card);
    if (answer.handler == nullptr && answer.event == nullptr) continue;
    CardSlot& slot = CardTable::OfProcess().slots[static_cast<size_t>(card)];
    // Who has the card may wait until the calling thread goes on; it sees to the interrupts itself.
    const std::unique_lock lock(slot.mutex, std::try_to_lock);
    if (lock.owns_lock() && slot.controller != nullptr) visit(card, slot, answer);
  }
}

void HostInterrupts::NoteTime() {
  VisitAnswered([](int, CardSlot& slot, const InterruptAnswer&) { slot.NoteTime(); });
}

bool HostInterrupts::Look() {
  bool late = false;
  VisitAnswered([&](int card, CardSlot& slot, const InterruptAnswer& answer) {
    const bool interrupts = slot.AdvanceToInterrupt();
    EndHostIfOver(&slot);
    if (!interrupts) return;
    late = late || slot.late();
    if (answer.event) answer.event->Set();
    if (answer.handler == nullptr) return;
    const std::lock_guard lock(mutex_);
    if (!std::exchange(cards_[static_cast<size_t>(card)].pending, true)) ++pending_;
  });
  return late;
}

int64_t HostInterrupts::NextNs() {
  const int64_t now_ns = VirtualTime::OfProcess().NowNs();
  int64_t next_ns = VirtualTime::kNeverNs;
  bool goes_on = false;
  VisitAnswered([&](int, CardSlot& slot, const InterruptAnswer&) {
    const int64_t earliest_ns = slot.EarliestInterruptNs();
    next_ns = std::min(next_ns, earliest_ns);
    goes_on = goes_on || (earliest_ns != VirtualTime::kNeverNs && slot.controller->GoesOn());
  });
  if (goes_on || quiet_since_ns_ == kUnknown) quiet_since_ns_ = now_ns;
  const int64_t end_ns = quiet_since_ns_ + kNothingComesNs;
  return now_ns >= end_ns ? VirtualTime::kNeverNs : std::min(next_ns, end_ns);
}

void HostInterrupts::Act() {
  NoteTime();
  Look();
  // The handler runs on a thread of the host, which may not be this one.
  if (pending_ != 0 && !disabled_ && !handles_) VirtualTime::OfProcess().WakeFirst();
}

// --- The host ------------------------------------------------------------------------------------

bool HostInterrupts::TakePending(int card) {
  const std::lock_guard lock(mutex_);
  if (!std::exchange(cards_[static_cast<size_t>(card)].pending, false)) return false;
  --pending_;
  return true;
}

// Handlers that take longer than the time between two interrupts would never let the host go on:
// what comes while a handler runs for the second time waits for the next call of the host.
void HostInterrupts::CallHandlers() {
  constexpr int kRounds = 2;
  if (pending_ == 0 || disabled_ || handles_.exchange(true)) return;
  for (int round = 0; round < kRounds; ++round) {
    for (int card = 0; card < kCardCount; ++card) {
      if (!TakePending(card)) continue;
      if (const auto handler = AnswerOf(card).handler) handler();
      if (const auto returned = Library().handler_returned) returned(card);
    }
  }
  handles_ = false;
}

// For the same reason only the time up to this moment is looked at.
void HostInterrupts::Come() {
  if (!Awaited() || call_state.depth != 0) return;
  quiet_since_ns_ = kUnknown;
  {
    const CallScope scope;
    NoteTime();
  }
  for (bool late = true; late;) {
    {
      const CallScope scope;
      late = Look();
    }
    CallHandlers();
  }
}

void HostInterrupts::PassUs(int64_t microseconds) {
  constexpr int64_t kNsPerUs = 1000;
  VirtualTime& time = VirtualTime::OfProcess();
  for (int64_t left_ns = microseconds * kNsPerUs; left_ns > 0;) {
    {
      const CallScope scope;
      const int64_t step_ns = std::clamp(NextNs() - time.NowNs(), int64_t{1}, left_ns);
      time.Pass(step_ns);
      left_ns -= step_ns;
    }
    Come();
  }
}

}  // namespace oncard::runtime
