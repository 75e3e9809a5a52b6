#include "motion/control.h"

#include <algorithm>

#include "motion/plant.h"
#include "motion/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<Control> && kFieldsComplete<PidSet> &&
              kFieldsComplete<ResponseCheck>);

/// The integral gain counts 256ths (GT-400 manual).
constexpr double kIntegralUnit = 1.0 / 256;

double Limited(double value, double limit) { return std::clamp(value, -limit, limit); }

double FedForward(const PidSet& pid, double feed, double velocity) {
  if (pid.kvff_filter == 0 && pid.kvff_acc_max <= 0) return velocity;
  double change = (velocity - feed) / (1 << pid.kvff_filter);
  if (pid.kvff_acc_max > 0) change = Limited(change, pid.kvff_acc_max * kServoMs);
  return feed + change;
}

}  // namespace

Control DefaultControl(int number) {
  Control control;
  control.axis = static_cast<int8_t>(number);
  control.encoder = static_cast<int8_t>(number);
  return control;
}

void Control::Begin(double position) {
  reference = position;
  sum = 0;
  error_before = 0;
  feed = 0;
}

double Control::Advance(double error, double velocity, double acceleration) {
  const PidSet& set = pid();
  sum = Limited(sum + error, set.integral_limit);
  const double difference = Limited(error - error_before, set.derivative_limit);
  error_before = error;
  feed = FedForward(set, feed, velocity);
  const double output = set.kp * error + set.ki * (sum * kIntegralUnit) + set.kd * difference +
                        set.kvff * feed + set.kaff * acceleration;
  return Limited(output, set.limit);
}

}  // namespace oncard::motion
