// When the cycles of a card are for those outside of it: the only place that converts between
// cycles, the time of the motion core and microseconds outside.
//
// The motion core counts cycles of a constant length in its own time. Outside, a cycle takes a
// whole number of nanoseconds, on some cards another one than in the core (Family::cycle_ns), and a
// command can change it while the card runs. Instants count from power-on. They are exact, and so
// stay those of any later cycle: nothing is rounded before it is asked for.
//
// A value without pointers. Tested by tests/runtime/card_clock_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>

namespace oncard::runtime {

class CardClock {
 public:
  static constexpr int64_t kNsPerUs = 1000;

  /// The last change of the length, or the power-on.
  struct Change {
    int64_t cycle = 0;      ///< the last cycle of the old length; 0: power-on
    int64_t end_ns = 0;     ///< its end
    int64_t before_ns = 0;  ///< the old length
    int64_t cycle_ns = 0;   ///< that of the cycles after it

    auto Fields(auto visit) const { return visit(cycle, end_ns, before_ns, cycle_ns); }
    bool operator==(const Change&) const = default;
  };

  /// A cycle takes `core_us` in the time of the motion core, and `cycle_ns` outside until the first
  /// change.
  CardClock(int64_t core_us, int64_t cycle_ns);

  /// The length of the newest cycles.
  int64_t cycle_ns() const { return last_.cycle_ns; }
  /// The same in microseconds, rounded up.
  int64_t cycle_us() const;

  /// The end of a cycle. Of those before the last change only that which ended with it, and those
  /// of its length, are known.
  int64_t NsOf(int64_t cycle) const;
  /// The same in whole microseconds, rounded down.
  int64_t UsOf(int64_t cycle) const { return NsOf(cycle) / kNsPerUs; }
  /// The same, rounded up: the first of them at which the cycle has passed.
  int64_t UsAfter(int64_t cycle) const;
  /// The first cycle that does not end before an instant.
  int64_t CycleAt(int64_t us) const;
  /// The last cycle that does not end after an instant, in nanoseconds.
  int64_t LastEnded(int64_t ns) const;
  /// The number of cycles that a duration has, the last one begun.
  int64_t CyclesIn(int64_t us) const;
  /// The reverse, rounded down.
  int64_t UsIn(int64_t cycles) const { return cycles * last_.cycle_ns / kNsPerUs; }

  /// The end of a cycle in the time of the motion core, in its microseconds.
  int64_t CoreUsOf(int64_t cycle) const { return cycle * core_us_; }
  /// The same for any instant outside, rounded up.
  int64_t CoreUs(int64_t us) const;
  /// The reverse.
  double FromCoreUs(double core_us) const;
  /// Milliseconds outside for one of the motion core; 1 on cards whose core counts milliseconds.
  double MsPerCoreMs() const;

  /// From now on cycles after `cycle`, which is not before the last change, have this length.
  void ChangeAfter(int64_t cycle, int64_t cycle_ns);
  /// The last change; empty since power-on.
  std::optional<Change> changed() const;
  /// Puts back what changed() has returned.
  void Restore(const std::optional<Change>& change);

  bool operator==(const CardClock&) const = default;

 private:
  /// The time of the core is that outside.
  bool plain() const { return last_ == at_power_on_ && last_.cycle_ns == core_us_ * kNsPerUs; }

  int64_t core_us_;
  Change at_power_on_;
  Change last_;
};

}  // namespace oncard::runtime
