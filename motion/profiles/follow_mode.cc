#include "motion/profiles/follow_mode.h"

#include <algorithm>
#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {

static_assert(kFieldsComplete<FollowMode> && kFieldsComplete<FollowSegment>);

void FollowMode::SetMemory(bool large) {
  large_memory = large;
  for (auto& segments : fifos) {
    segments.clear();
    segments.reserve(Capacity());
  }
}

double FollowMode::Direction(uint8_t which, const MasterValue& value) const {
  if (event == FollowEvent::kPass || !MasterTravel{direction}.Counts(value.velocity)) return 0;
  // In the other direction the slave waits.
  const FollowSegment& first = fifos[which].front();
  return first.master * value.velocity > 0 ? first.slave : 0;
}

void FollowMode::Start(const Sample& from, const MasterValue& value) {
  running = true;
  waiting = event == FollowEvent::kPass;
  switching = false;
  passes = 0;
  segment = 0;
  slave_base = from.position;
  pass_ratio = 0;
  travel.direction = direction;
  travel.Restart(value.position);
  EnterSegment(0);
}

bool FollowMode::EventBetween(double before, double after) const {
  const bool up = before < event_position && event_position <= after;
  const bool down = before > event_position && event_position >= after;
  return event_direction > 0 ? up : down;
}

FollowSegment FollowMode::BeginOf(uint32_t index) const {
  return index == 0 ? FollowSegment{} : fifos[fifo][index - 1];
}

double FollowMode::PartOf(uint32_t index) const {
  const double begin = BeginOf(index).master;
  return (travel.travel - begin) / (fifos[fifo][index].master - begin);
}

void FollowMode::EnterSegment(double ratio_before) {
  const FollowSegment begin = BeginOf(segment);
  const FollowSegment& end = fifos[fifo][segment];
  const double mean = (end.slave - begin.slave) / (end.master - begin.master);
  switch (end.type) {
    case FollowSegmentType::kNormal:
      first_ratio = segment == 0 ? 0 : ratio_before;
      last_ratio = 2 * mean - first_ratio;
      break;
    case FollowSegmentType::kContinue:
      first_ratio = ratio_before;
      last_ratio = 2 * mean - first_ratio;
      break;
    case FollowSegmentType::kEven:
      first_ratio = mean;
      last_ratio = mean;
      break;
    case FollowSegmentType::kStop:
      first_ratio = 2 * mean;
      last_ratio = 0;
      break;
  }
}

bool FollowMode::NextPass() {
  const FollowSegment end = fifos[fifo].back();
  ++passes;
  if (switching) {
    fifos[fifo].clear();
    fifo = static_cast<uint8_t>(1 - fifo);
    switching = false;
    passes = 0;
  } else if (loop >= 1 && passes >= loop) {
    return false;
  }
  slave_base += end.slave;
  travel.travel -= end.master;
  pass_ratio = last_ratio;
  segment = 0;
  EnterSegment(pass_ratio);
  return true;
}

void FollowMode::SkipPasses() {
  const FollowSegment end = fifos[fifo].back();
  // In a table that begins with CONTINUE each pass depends on the one before.
  if (switching || fifos[fifo].front().type == FollowSegmentType::kContinue) return;
  double whole = std::floor(travel.travel / end.master) - 1;
  if (loop >= 1) whole = std::min(whole, static_cast<double>(loop - passes - 1));
  if (whole < 1) return;
  slave_base += whole * end.slave;
  travel.travel -= whole * end.master;
  passes = static_cast<int32_t>(std::min(passes + whole, 2147483647.0));
}

bool FollowMode::FindSegment() {
  SkipPasses();
  while (PartOf(segment) >= 1) {
    if (segment + 1 < fifos[fifo].size()) {
      ++segment;
      EnterSegment(last_ratio);
    } else if (!NextPass()) {
      return false;
    }
  }
  while (PartOf(segment) < 0 && segment > 0) {
    // The master has turned back: the ratios are computed again from the beginning of the pass.
    const uint32_t wanted = segment - 1;
    segment = 0;
    EnterSegment(pass_ratio);
    while (segment < wanted) {
      ++segment;
      EnterSegment(last_ratio);
    }
  }
  return true;
}

Sample FollowMode::At(const Sample& now, const MasterValue& value) {
  if (waiting) {
    const bool begins = EventBetween(travel.last, value.position);
    travel.Restart(begins ? event_position : value.position);
    if (!begins) return {now.position, 0, 0, true};
    waiting = false;
  }
  travel.MoveTo(value.position);
  if (!FindSegment()) {
    running = false;
    return AtRest(slave_base + fifos[fifo].back().slave);
  }
  const FollowSegment begin = BeginOf(segment);
  const double length = fifos[fifo][segment].master - begin.master;
  // Before the beginning of the pass the slave waits.
  const double part = std::max(PartOf(segment), 0.0);
  const double bend = (last_ratio - first_ratio) / length;
  const double x = part * length;
  const bool follows = travel.Counts(value.velocity) && PartOf(segment) >= 0;
  const double ratio = follows ? first_ratio + bend * x : 0;
  return {slave_base + begin.slave + x * (first_ratio + bend / 2 * x), ratio * value.velocity,
          ratio * value.acceleration + (follows ? bend * value.velocity * value.velocity : 0),
          true};
}

}  // namespace oncard::motion
