// How a card's time follows its host. With the virtual clock it follows the process's virtual time
// (virtual_time.h), in which a host call takes what the manual says it costs: the same host program
// gives the same run every time. With the real-time clock it follows the wall clock, optionally
// scaled.
//
// Either way the card catches up when the host calls: what it does between two calls cannot be
// observed before the second one, so no thread of its own is needed. Gaps of the real-time clock
// are bounded by kCatchUpLimitUs, so that a call after a night's pause returns soon, and a computer
// that is too slow for the scale falls behind instead of having more to catch up with at every
// call. Tested by tests/runtime/clock_test.cc.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "base/result.h"
#include "runtime/host/virtual_time.h"

namespace oncard::runtime {

/// GT_Open's code when the card cannot be opened (GTS manual table 3-1).
inline constexpr int16_t kOpenFailed = -6;

enum class ClockKind : uint8_t { kVirtual, kReal };

/// Which clock a card has. The default is the one a real card has.
struct ClockSetting {
  ClockKind kind = ClockKind::kReal;
  double scale = 1;  ///< kReal: milliseconds of the card per millisecond of the wall clock
  bool operator==(const ClockSetting&) const = default;
};

/// Largest scale of the real-time clock.
inline constexpr double kClockScaleMax = 1e6;

/// Reads the value of ONCARD_CLOCK: `real`, `real:SCALE` (0 < SCALE <= 1000000) or `virtual`. An
/// empty text means `real`. Fails with -6, the code of GT_Open.
Result<ClockSetting> ParseClockSetting(std::string_view text);

/// The most that the real-time clock lets pass at one call: ten minutes of the card's time. A
/// longer gap is cut, as if the card had stood still meanwhile.
inline constexpr int64_t kCatchUpLimitUs = 600'000'000;

/// How long one catching up may take on the wall clock before the card is said to be too slow; an
/// operating system that takes the processor away for a moment stays below it.
inline constexpr int64_t kBehindLimitNs = 100'000'000;

/// The clock of one card. Not thread-safe.
class CardClock {
 public:
  /// Nanoseconds of a clock that never goes back.
  using WallClock = std::function<int64_t()>;

  /// `wall_clock` is asked only by the real-time clock, `virtual_time` only by the virtual one;
  /// tests replace them.
  explicit CardClock(const ClockSetting& setting, WallClock wall_clock = SteadyNanoseconds,
                     VirtualTime& virtual_time = VirtualTime::OfProcess());

  /// How many microseconds of the card's time pass before a host call that costs `cost_us`: all
  /// that have passed since the last call, or the opening.
  int64_t TakeUs(int64_t cost_us);

  /// To be called when the card has gone through the time that TakeUs() gave. If that took longer
  /// than the time it stands for, and more than kBehindLimitNs, it is not caught up with in turn.
  void CaughtUp();

  /// The system's steady clock.
  static int64_t SteadyNanoseconds();

 private:
  ClockSetting setting_;
  WallClock wall_clock_;
  VirtualTime& virtual_time_;
  int64_t last_ns_ = 0;
  double fraction_us_ = 0;  // part of a microsecond not given out yet
  int64_t taken_us_ = 0;    // what TakeUs() gave last
};

}  // namespace oncard::runtime
