#include "motion/mechanics/switches_and_marks.h"

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<PositionSwitch> && kFieldsComplete<IndexMarks>);

}  // namespace

SwitchPassage PassSwitch(const PositionSwitch& contact, double from, double to) {
  SwitchPassage passage;
  if (from < to) {
    passage.enters = from < contact.first && contact.first <= to;
    passage.entry = contact.first;
    passage.leaves = from <= contact.last && contact.last < to;
    passage.exit = contact.last;
  } else if (to < from) {
    passage.enters = from > contact.last && contact.last >= to;
    passage.entry = contact.last;
    passage.leaves = from >= contact.first && contact.first > to;
    passage.exit = contact.first;
  }
  return passage;
}

}  // namespace oncard::motion
