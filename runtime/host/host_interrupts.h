// Interrupts of the cards of this process, as their host answers them: with a handler, as under
// DOS, or with an event for which its threads wait, as under Windows.
//
// A card interrupts its host at the end of a tick. Nothing runs beside the host that it has not
// started: a handler is called on the thread whose call, sleep or look at a clock lets the tick
// pass, after it and before the next one, with no card locked, as the handler of a signal is at a
// system call. It may make calls, which take their time. Further interrupts wait until it returns;
// then the interrupted call goes on and acts. A command that ends with a tick acts before the
// interrupt of this tick.
//
// In virtual time the cards are a source of wake-ups (virtual_time.h). If all threads wait for
// events while nothing goes on, they are told after kNothingComesNs that the wait has failed. With
// the real clock a thread that waits lets the cards catch up by itself, each kRealStepNs.
//
// Thread-safe. Tested by tests/families/toy_family_test.cc.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

#include "runtime/host/host_api.h"
#include "runtime/host/virtual_time.h"

namespace oncard::runtime {

/// Assumption: so much virtual time without anything that could lead to an interrupt is enough.
inline constexpr int64_t kNothingComesNs = 60'000'000'000;
/// How long a thread that waits with the real clock sleeps before it looks at the cards again.
inline constexpr int64_t kRealStepNs = 1'000'000;

/// An event of the host, for which its threads wait.
class InterruptEvent {
 public:
  InterruptEvent() = default;
  InterruptEvent(const InterruptEvent&) = delete;
  InterruptEvent& operator=(const InterruptEvent&) = delete;
  virtual ~InterruptEvent() = default;

  /// Wakes those who wait for it. May be called with a card locked.
  virtual void Set() = 0;
};

/// The event that has a handle; nullptr if there is none.
std::shared_ptr<InterruptEvent> InterruptEventOf(void* handle);

/// Says once that a wait has failed after kNothingComesNs; a host may wait again and again.
void ReportHopelessWait();

/// What a host does when a card interrupts it.
struct InterruptAnswer {
  void (*handler)() = nullptr;
  std::shared_ptr<InterruptEvent> event = nullptr;  ///< is set
};

class HostInterrupts final : public WakeUps {
 public:
  /// The process's own.
  static HostInterrupts& OfProcess();

  /// How the host answers the interrupts of a card from now on. An open card may be locked.
  void Answer(int card, InterruptAnswer answer);
  InterruptAnswer AnswerOf(int card);
  /// True if the host answers those of any card.
  bool Awaited() const { return answered_ != 0; }
  /// Virtual time asks this object for wake-ups from now on.
  void Listen();
  /// While the host has disabled interrupts, its handlers wait.
  void Disable() { disabled_ = true; }
  void Enable();

  // The calling thread is in no call, and no card is locked.

  /// Handles the interrupts that have come by now.
  void Come();
  /// Lets time pass for a call that takes this long, with the interrupts that come meanwhile.
  void PassUs(int64_t microseconds);

  int64_t NextNs() override;
  void Act() override;

 private:
  HostInterrupts() = default;

  struct Answered {
    InterruptAnswer answer;
    bool pending = false;  ///< the handler is to be called
  };

  /// Calls `visit(card, slot, answer)` for each open card whose interrupts the host answers, unless
  /// another thread uses it. The card is locked.
  template <typename Visit>
  void VisitAnswered(const Visit& visit);
  /// Takes note of the time that has passed for these cards.
  void NoteTime();
  /// Lets each card go on to its next interrupt that is due; true if the time of one is not over.
  bool Look();
  /// Calls the handlers that are to be called, unless one runs.
  void CallHandlers();
  /// True if the handler of the card was to be called.
  bool TakePending(int card);

  std::atomic<int> answered_ = 0;
  std::atomic<bool> disabled_ = false;
  std::atomic<bool> handles_ = false;  ///< a handler runs
  std::atomic<int> pending_ = 0;
  std::atomic<int64_t> quiet_since_ns_ = kUnknown;
  std::mutex mutex_;  // guards what follows
  std::array<Answered, kCardCount> cards_;

  static constexpr int64_t kUnknown = -1;
};

}  // namespace oncard::runtime
