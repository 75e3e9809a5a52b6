#include "gtcalls/gt400/gt400_state.h"

#include "motion/common/state_hash.h"

namespace oncard::gtcalls {
namespace {

static_assert(motion::kFieldsComplete<gt400::AxisRegisters> &&
              motion::kFieldsComplete<gt400::UpdateRequest> &&
              motion::kFieldsComplete<gt400::TakenUpdate> &&
              motion::kFieldsComplete<gt400::TakenHoming> &&
              motion::kFieldsComplete<gt400::Gt400Axis> &&
              motion::kFieldsComplete<gt400::PathList> && motion::kFieldsComplete<gt400::Path> &&
              motion::kFieldsComplete<Gt400State>);

}  // namespace
}  // namespace oncard::gtcalls
