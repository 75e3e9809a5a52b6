#include "motion/io/analog.h"

#include <algorithm>
#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<Dac> && kFieldsComplete<Adc>);

/// A filtered voltage so close to the terminal's has reached it: a tenth of the converter's step.
constexpr double kArrivedVolts = kAdcFullVolts / kAdcFull / 10;

}  // namespace

double Dac::Volts() const {
  const double volts = Output() * kDacFullVolts / kDacFull;
  return reversed ? -volts : volts;
}

void Adc::Sample() {
  if (filtered == volts) return;
  if (filter <= 1 || std::fabs(volts - filtered) < kArrivedVolts) {
    filtered = volts;
  } else {
    filtered += (volts - filtered) / filter;
  }
}

int16_t Adc::Value() const {
  const double value = std::round(filtered * kAdcFull / kAdcFullVolts);
  return static_cast<int16_t>(std::clamp(value, -kAdcFull, kAdcFull - 1));
}

}  // namespace oncard::motion
