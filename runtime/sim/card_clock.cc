#include "runtime/sim/card_clock.h"

#include <algorithm>
#include <cmath>

namespace oncard::runtime {
namespace {

/// Later instants count as this one, so that their nanoseconds fit: 146 years.
constexpr int64_t kUsMax = INT64_MAX / 2000;

/// Of numbers that are not negative.
int64_t DividedUp(int64_t dividend, int64_t divisor) {
  return dividend / divisor + (dividend % divisor != 0 ? 1 : 0);
}

}  // namespace

CardClock::CardClock(int64_t core_us, int64_t cycle_ns)
    : core_us_(core_us),
      at_power_on_{.before_ns = cycle_ns, .cycle_ns = cycle_ns},
      last_(at_power_on_) {}

int64_t CardClock::cycle_us() const { return DividedUp(last_.cycle_ns, kNsPerUs); }

int64_t CardClock::NsOf(int64_t cycle) const {
  const int64_t cycles = cycle - last_.cycle;
  return last_.end_ns + cycles * (cycles < 0 ? last_.before_ns : last_.cycle_ns);
}

int64_t CardClock::UsAfter(int64_t cycle) const { return DividedUp(NsOf(cycle), kNsPerUs); }

int64_t CardClock::CycleAt(int64_t us) const {
  const int64_t ns = std::min(us, kUsMax) * kNsPerUs - last_.end_ns;
  return ns < 0 ? last_.cycle - -ns / last_.before_ns : last_.cycle + DividedUp(ns, last_.cycle_ns);
}

int64_t CardClock::LastEnded(int64_t ns) const {
  const int64_t after_ns = ns - last_.end_ns;
  return after_ns < 0 ? last_.cycle - DividedUp(-after_ns, last_.before_ns)
                      : last_.cycle + after_ns / last_.cycle_ns;
}

int64_t CardClock::CyclesIn(int64_t us) const {
  return DividedUp(std::min(us, kUsMax) * kNsPerUs, last_.cycle_ns);
}

int64_t CardClock::CoreUs(int64_t us) const {
  if (plain()) return us;
  const int64_t cycle = CycleAt(us);
  const int64_t end_ns = NsOf(cycle);
  const int64_t rest_ns = end_ns - std::min(us, kUsMax) * kNsPerUs;
  const int64_t length_ns = end_ns - NsOf(cycle - 1);
  return (cycle - 1) * core_us_ + DividedUp(core_us_ * (length_ns - rest_ns), length_ns);
}

double CardClock::FromCoreUs(double core_us) const {
  if (plain()) return core_us;
  const auto length = static_cast<double>(core_us_);
  const double cycles = std::floor(core_us / length);
  const auto begin = static_cast<int64_t>(cycles);
  const auto length_ns = static_cast<double>(NsOf(begin + 1) - NsOf(begin));
  const double within_ns = (core_us - cycles * length) / length * length_ns;
  return (static_cast<double>(NsOf(begin)) + within_ns) / kNsPerUs;
}

double CardClock::MsPerCoreMs() const {
  return static_cast<double>(last_.cycle_ns) / static_cast<double>(core_us_ * kNsPerUs);
}

void CardClock::ChangeAfter(int64_t cycle, int64_t cycle_ns) {
  // Of the cycle that ends with an earlier change the length stays known.
  if (cycle != last_.cycle || last_ == at_power_on_) {
    last_ = {cycle, NsOf(cycle), last_.cycle_ns, cycle_ns};
  } else {
    last_.cycle_ns = cycle_ns;
  }
}

std::optional<CardClock::Change> CardClock::changed() const {
  return last_ == at_power_on_ ? std::nullopt : std::optional(last_);
}

void CardClock::Restore(const std::optional<Change>& change) {
  last_ = change.value_or(at_power_on_);
}

}  // namespace oncard::runtime
