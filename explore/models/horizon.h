// What still goes on where the runs of a card end: nothing has been checked behind that instant. A
// verdict that says so is a bound, not a proof. Plain values. Tested by
// tests/explore/horizon_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/message.h"

namespace oncard::explore {

/// Of all runs that have ended without a failure.
struct Horizon {
  /// The instant at which every run is ended, if there is one; otherwise it ends with its threads.
  std::optional<double> at_ms;
  uint32_t axes = 0;     ///< bit n: axis n + 1 still moves in one of the runs
  uint32_t threads = 0;  ///< bit n: thread n of the card still runs in one of them

  /// True if something still goes on.
  explicit operator bool() const { return axes != 0 || threads != 0; }
};

/// `up to 500 ms: axis 1 still moves, threads 2, 3 still run`.
Message DescribeHorizon(const Horizon& horizon);

/// The numbers of the bits that are set, in ascending order, each plus `first`.
std::vector<int> NumbersOf(uint32_t bits, int first);

}  // namespace oncard::explore
