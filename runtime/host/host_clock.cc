#include "runtime/host/host_clock.h"

#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "base/number.h"

namespace oncard::runtime {

Result<ClockSetting> ParseClockSetting(std::string_view text) {
  constexpr std::string_view kScalePrefix = "real:";
  if (text.empty() || text == "real") return ClockSetting{};
  if (text == "virtual") return ClockSetting{ClockKind::kVirtual, 1};
  if (text.starts_with(kScalePrefix)) {
    const auto scale = ReadNumber(text.substr(kScalePrefix.size()));
    if (scale && *scale > 0 && *scale <= kClockScaleMax) {
      return ClockSetting{ClockKind::kReal, *scale};
    }
  }
  return MakeError(1,
                   "ONCARD_CLOCK is '{}', expected real, real:SCALE with a scale above 0 and at "
                   "most 1000000, or virtual",
                   "ONCARD_CLOCK 的值为 '{}'，应为 real、real:倍率（大于 0 且不超过 1000000）或 "
                   "virtual",
                   text);
}

HostClock::HostClock(const ClockSetting& setting, WallClock wall_clock, VirtualTime& virtual_time)
    : setting_(setting), wall_clock_(std::move(wall_clock)), virtual_time_(virtual_time) {
  last_ns_ = setting_.kind == ClockKind::kReal ? wall_clock_() : virtual_time_.NowNs();
}

int64_t HostClock::TakeUs(int64_t cost_us) {
  if (setting_.kind == ClockKind::kVirtual) {
    const int64_t passed_us = (virtual_time_.Pass(cost_us * 1000) - last_ns_) / 1000;
    last_ns_ += passed_us * 1000;
    return passed_us;
  }
  const int64_t now_ns = wall_clock_();
  const double elapsed_us =
      fraction_us_ + static_cast<double>(now_ns - last_ns_) * setting_.scale / 1000;
  last_ns_ = now_ns;
  if (elapsed_us >= static_cast<double>(kCatchUpLimitUs)) {
    fraction_us_ = 0;
    taken_us_ = kCatchUpLimitUs;
    return taken_us_;
  }
  const double whole_us = std::floor(elapsed_us);
  fraction_us_ = elapsed_us - whole_us;
  taken_us_ = static_cast<int64_t>(whole_us);
  return taken_us_;
}

int64_t HostClock::WaitUs(int64_t microseconds) {
  if (setting_.kind == ClockKind::kVirtual) return TakeUs(microseconds);
  const double wall_us = static_cast<double>(microseconds) / setting_.scale;
  std::this_thread::sleep_for(std::chrono::duration<double, std::micro>(wall_us));
  return TakeUs(0);
}

void HostClock::CaughtUp() {
  if (setting_.kind == ClockKind::kVirtual) return;
  const int64_t now_ns = wall_clock_();
  const int64_t spent_ns = now_ns - last_ns_;
  const double spent_us = static_cast<double>(spent_ns) * setting_.scale / 1000;
  if (spent_ns > kBehindLimitNs && spent_us > static_cast<double>(taken_us_)) last_ns_ = now_ns;
}

int64_t HostClock::EarliestNs(int64_t microseconds) const {
  return setting_.kind == ClockKind::kVirtual ? last_ns_ + microseconds * 1000 : 0;
}

int64_t HostClock::SteadyNanoseconds() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace oncard::runtime
