#include "motion/profiles/pvt_mode.h"

#include <utility>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<PvtMode>);

}  // namespace

void PvtMode::Select(uint16_t number, PvtTablePointer chosen) {
  selected = number;
  if (running) next = std::move(chosen);
}

void PvtMode::TakeNext() {
  table = std::move(next);
  next.reset();
  current = selected;
}

void PvtMode::Start(Micros now, const Sample& from) {
  running = true;
  TakeNext();
  begin = now;
  pass_begin = table->begin;
  origin = from.position;
  loop_count = 0;
  time = 0;
}

bool PvtMode::NextPass() {
  pass_begin += table->period();
  origin += table->travel;
  ++loop_count;
  if (loop_target != 0 && loop_count >= loop_target) return false;
  if (next != nullptr) TakeNext();
  return table->period() > 0;
}

Sample PvtMode::At(Micros now) {
  const double elapsed = MsBetween(begin, now);
  while (elapsed - pass_begin >= table->period()) {
    const double last = table->end;
    if (!NextPass()) {
      time = last;
      Halt();
      return AtRest(origin);
    }
  }
  time = table->begin + (elapsed - pass_begin);
  Sample sample = table->At(time);
  sample.position += origin;
  return sample;
}

void PvtMode::Halt() {
  running = false;
  table.reset();
  next.reset();
}

}  // namespace oncard::motion
