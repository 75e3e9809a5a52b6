#include "gtcalls/gts/gts_state.h"

#include "motion/common/state_hash.h"

namespace oncard::gtcalls {

static_assert(motion::kFieldsComplete<GtsState>);

void GtsState::Reset() {
  mram.Reset();
  long_vars.fill(0);
  double_vars.fill(0);
  plc = {};
  look_ahead = {};
}

}  // namespace oncard::gtcalls
