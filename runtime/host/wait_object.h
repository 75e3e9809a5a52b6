// What the threads of a host wait for with WaitForSingleObject(): events, and the ends of threads.
// In virtual time a thread that waits lets time go on, as one that sleeps (virtual_time.h); with
// the real clock it looks at the cards that may interrupt the host by itself (host_interrupts.h).
//
// A host knows an object by its handle, which is checked at every use. Thread-safe. Linux only.
// Tested by tests/families/toy_family_test.cc and tests/families/gt400/gt400_family_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

#include "runtime/host/host_interrupts.h"

namespace oncard::runtime {

class WaitObject final : public InterruptEvent {
 public:
  enum class Kind : uint8_t {
    kManualEvent,     ///< stays set until it is reset
    kAutomaticEvent,  ///< one wait that ends because it is set resets it
    kThread           ///< is set when the thread ends
  };
  /// How a wait has ended.
  enum class End : uint8_t { kSet, kTimeOut, kFailed };

  WaitObject(Kind kind, bool is_set) : kind_(kind), is_set_(is_set) {}

  bool is_event() const { return kind_ != Kind::kThread; }
  /// Sets it, and wakes those who wait: if it is an automatic event one of them, else all.
  void Set() override;
  void Reset();
  /// Waits until it is set, at most this long; a negative duration means for ever. A duration of 0
  /// counts as reading the clock. Fails if nobody can set it any more. To be called outside of a
  /// CallScope.
  End Wait(int64_t duration_ns);

 private:
  bool Take();
  End WaitInVirtualTime(int64_t duration_ns);
  End WaitInRealTime(int64_t duration_ns);

  std::mutex mutex_;  // guards is_set_
  const Kind kind_;
  bool is_set_;
  std::atomic<int> changes_ = 0;  // a futex
};

/// A handle for the object, which lives as long as it is open and anybody uses it.
void* OpenHandle(std::shared_ptr<WaitObject> object);
/// nullptr if there is no such handle.
std::shared_ptr<WaitObject> FindObject(const void* handle);
/// The same, also for the handle of a thread.
std::shared_ptr<WaitObject> FindEvent(const void* handle);
/// False if there is no such handle.
bool CloseHandle(const void* handle);

}  // namespace oncard::runtime
