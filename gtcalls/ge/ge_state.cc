#include "gtcalls/ge/ge_state.h"

#include "motion/common/state_hash.h"

namespace oncard::gtcalls {
namespace {

static_assert(motion::kFieldsComplete<GeRegisters> && motion::kFieldsComplete<GeAxis> &&
              motion::kFieldsComplete<GeState> && motion::kFieldsComplete<Refresh<double>>);

}  // namespace

void GeRegisters::Update() {
  const auto update = [](auto&... registers) { (registers.Update(), ...); };
  update(position, velocity, acceleration, max_acceleration, jerk, kp, ki, kd, kvff, kaff,
         integral_limit, output_limit, bias, error_limit);
}

}  // namespace oncard::gtcalls
