#include "motion/control.h"

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<Control> && kFieldsComplete<PidSet> &&
              kFieldsComplete<ResponseCheck>);

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

}  // namespace oncard::motion
