#include "motion/axis.h"

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<Axis> && kFieldsComplete<AxisValue> &&
              kFieldsComplete<VelocityFilter> && kFieldsComplete<Scale> &&
              kFieldsComplete<InputChoice>);

}  // namespace

void VelocityFilter::Set(int16_t new_exponent, double velocity) {
  exponent = new_exponent;
  next = 0;
  window.assign(exponent > 0 ? size_t{1} << exponent : 0, velocity);
}

double VelocityFilter::Mean(double velocity) const {
  if (window.empty()) return velocity;
  double sum = 0;
  for (const double value : window) sum += value;
  return sum / static_cast<double>(window.size());
}

Axis DefaultAxis(int number) {
  const auto bit = static_cast<int16_t>(number);
  Axis axis;
  axis.alarm = {DiType::kAlarm, bit};
  axis.positive_limit = {DiType::kLimitPositive, bit};
  axis.negative_limit = {DiType::kLimitNegative, bit};
  axis.profile_map = uint32_t{1} << number;
  axis.encoder_map = uint32_t{1} << number;
  return axis;
}

}  // namespace oncard::motion
