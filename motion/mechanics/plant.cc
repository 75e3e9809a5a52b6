#include "motion/mechanics/plant.h"

#include "motion/common/state_hash.h"
#include "motion/io/analog.h"

namespace oncard::motion {

static_assert(kFieldsComplete<Drive> && kFieldsComplete<Plant> && kFieldsComplete<Step>);

double ExpMinus(double x) {
  constexpr double kSmall = 1.0 / 64;
  constexpr int kTerms = 8;  // the next one is below 64^-9 / 9!, 1e-21
  int squarings = 0;
  while (x > kSmall) {
    x /= 2;
    ++squarings;
  }
  double value = 1;
  for (int n = kTerms; n > 0; --n) value = 1 - value * x / n;
  for (; squarings > 0; --squarings) value *= value;
  return value;
}

void Drive::Prepare(double servo_ms) {
  unit = gain / kDacFull;
  decay = tau > 0 ? ExpMinus(servo_ms / tau) : 0;
  lag = tau * (1 - decay);
}

Drive VelocityDrive(double gain, double tau, double friction, double servo_ms) {
  Drive drive{.kind = DriveKind::kVelocity, .gain = gain, .tau = tau, .friction = friction};
  drive.Prepare(servo_ms);
  return drive;
}

}  // namespace oncard::motion
