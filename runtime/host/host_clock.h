// How a card's time follows its host. With the virtual clock it follows the process's virtual time
// (virtual_time.h), in which each host call takes the time given in the manual: the same host
// program gives the same run every time. With the real-time clock it follows the wall clock,
// optionally scaled.
//
// In both cases the card catches up when the host makes a call: its behaviour between two calls
// cannot be observed before the second one, so it needs no thread of its own. Gaps of the real-time
// clock are limited by kCatchUpLimitUs, so that a call after a long pause returns soon. A computer
// that is too slow for the scale falls behind, instead of accumulating more and more time to catch
// up with. Tested by tests/runtime/host_clock_test.cc.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "base/result.h"
#include "runtime/host/virtual_time.h"

namespace oncard::runtime {

enum class ClockKind : uint8_t { kVirtual, kReal };

/// The kind of clock of a card. The default is real time, as for a real card.
struct ClockSetting {
  ClockKind kind = ClockKind::kReal;
  double scale = 1;  ///< kReal: milliseconds of the card per millisecond of the wall clock
  bool operator==(const ClockSetting&) const = default;
};

/// Largest scale of the real-time clock.
inline constexpr double kClockScaleMax = 1e6;

/// Reads the value of ONCARD_CLOCK: `real`, `real:SCALE` (0 < SCALE <= 1000000) or `virtual`. An
/// empty text means `real`.
Result<ClockSetting> ParseClockSetting(std::string_view text);

/// The longest time that the real-time clock advances at one call: ten minutes of card time. A
/// longer gap is cut, as if the card had been stopped in between.
inline constexpr int64_t kCatchUpLimitUs = 600'000'000;

/// How long catching up may take on the wall clock before the card counts as too slow; short
/// interruptions by the operating system stay below it.
inline constexpr int64_t kBehindLimitNs = 100'000'000;

/// How the time of one card follows its host. Not thread-safe.
class HostClock {
 public:
  /// Returns the nanoseconds of a monotonic clock.
  using WallClock = std::function<int64_t()>;

  /// `wall_clock` is used only by the real-time clock, `virtual_time` only by the virtual one;
  /// tests replace them.
  explicit HostClock(const ClockSetting& setting, WallClock wall_clock = SteadyNanoseconds,
                     VirtualTime& virtual_time = VirtualTime::OfProcess());

  /// The microseconds of card time that pass before a host call that takes `cost_us`: all since the
  /// last call or the opening.
  int64_t TakeUs(int64_t cost_us);

  /// Lets so many microseconds of card time pass before it does the same.
  int64_t WaitUs(int64_t microseconds);

  /// To be called when the card has simulated the time from TakeUs(). If that took longer than the
  /// simulated time, and longer than kBehindLimitNs, the difference is dropped.
  void CaughtUp();

  /// The virtual time at which TakeUs(0) returns this much; 0 with the real-time clock, where it
  /// may do so at any moment.
  int64_t EarliestNs(int64_t microseconds) const;

  /// The system's steady clock.
  static int64_t SteadyNanoseconds();

 private:
  ClockSetting setting_;
  WallClock wall_clock_;
  VirtualTime& virtual_time_;
  int64_t last_ns_ = 0;
  double fraction_us_ = 0;  // fraction of a microsecond not yet returned
  int64_t taken_us_ = 0;    // last result of TakeUs()
};

}  // namespace oncard::runtime
