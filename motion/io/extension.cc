#include "motion/io/extension.h"

#include <algorithm>
#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<ExtensionModule>);

constexpr double kLargest = 65535;

}  // namespace

uint16_t ModuleValue(double volts) {
  const double bounded = std::clamp(volts, -kModuleFullVolts, kModuleFullVolts);
  return static_cast<uint16_t>(
      std::round((bounded + kModuleFullVolts) / (2 * kModuleFullVolts) * kLargest));
}

double ModuleVolts(uint16_t value) {
  return value * (2 * kModuleFullVolts) / kLargest - kModuleFullVolts;
}

}  // namespace oncard::motion
