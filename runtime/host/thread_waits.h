// Whether the threads of the host wait, which virtual time (virtual_time.h) asks before every jump.
// Where the operating system says it, as Linux does, it is asked (waiting_threads.h). Thread-safe.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/host/calling_thread.h"

namespace oncard::runtime {

/// Whether threads wait, and for what.
enum class Waits : uint8_t {
  kNot,         ///< one of them runs
  kForThreads,  ///< each for others, or with a deadline
  kForOutside,  ///< one of them at least for what may come from outside, or for what is not known
};

/// Whether all threads of the process except the calling one wait. Threads `asleep` do: they are
/// not looked at. Threads `in_slices` wait for something again and again, up to a deadline: they
/// may have run from one such wait to the next.
Waits HowOthersWait(std::span<const ThreadId> asleep, std::span<const ThreadId> in_slices);

/// During its lifetime the calling thread does not belong to the host: it is not looked at.
class LeftOutThread {
 public:
  LeftOutThread();
  LeftOutThread(const LeftOutThread&) = delete;
  LeftOutThread& operator=(const LeftOutThread&) = delete;
  ~LeftOutThread();
};

}  // namespace oncard::runtime
