#include "gtcalls/gt400/gt400_state.h"

#include <utility>

#include "motion/common/state_hash.h"

namespace oncard::gtcalls {
namespace {

static_assert(motion::kFieldsComplete<gt400::AxisRegisters> &&
              motion::kFieldsComplete<gt400::UpdateRequest> &&
              motion::kFieldsComplete<gt400::TakenUpdate> &&
              motion::kFieldsComplete<gt400::TakenHoming> &&
              motion::kFieldsComplete<gt400::Gt400Axis> &&
              motion::kFieldsComplete<gt400::PathList> && motion::kFieldsComplete<gt400::Path> &&
              motion::kFieldsComplete<gt400::BackgroundSet> &&
              motion::kFieldsComplete<gt400::InterruptAnswers> &&
              motion::kFieldsComplete<gt400::InterruptUnit> && motion::kFieldsComplete<Gt400State>);

}  // namespace

void Gt400State::Reset() {
  gt400::InterruptAnswers answers = std::move(interrupts.answers);
  *this = {};
  interrupts.answers = std::move(answers);
}

}  // namespace oncard::gtcalls
