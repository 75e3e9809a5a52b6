#include "motion/profiles/pt_mode.h"

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<PtMode> && kFieldsComplete<PtSegment>);

}  // namespace

void PtMode::SetDynamic(bool value) {
  if (dynamic == value) return;
  Clear(0);
  Clear(1);
  dynamic = value;
}

size_t PtMode::Space(size_t buffer) const {
  if (!dynamic) return capacity() - buffers[buffer].size();
  const size_t here = capacity() - buffers[write_buffer].size();
  return buffers[1 - write_buffer].empty() ? here + capacity() : here;
}

const PtSegment* PtMode::LastSegment(size_t buffer) const {
  if (dynamic) return Empty() ? nullptr : &last;
  return buffers[buffer].empty() ? nullptr : &buffers[buffer].back();
}

int32_t PtMode::LastTime(size_t buffer) const {
  const PtSegment* before = LastSegment(buffer);
  return before == nullptr ? 0 : before->end_time;
}

void PtMode::Append(size_t buffer, double position, int32_t time, PtSegmentType type,
                    int32_t segment_number) {
  PtSegment segment;
  if (const PtSegment* before = LastSegment(buffer)) {
    segment.begin = before->end;
    segment.begin_time = before->end_time;
    segment.velocity = before->end_velocity;
  }
  segment.end = position;
  segment.end_time = time;
  segment.number = segment_number;
  const double mean = (position - segment.begin) / (time - segment.begin_time);
  switch (type) {
    case PtSegmentType::kNormal:
      segment.end_velocity = 2 * mean - segment.velocity;
      break;
    case PtSegmentType::kEven:
      segment.velocity = mean;
      segment.end_velocity = mean;
      break;
    case PtSegmentType::kStop:
      segment.velocity = 2 * mean;
      segment.end_velocity = 0;
      break;
  }
  if (dynamic) {
    if (buffers[write_buffer].size() == capacity()) write_buffer = 1 - write_buffer;
    buffer = write_buffer;
    last = segment;
  }
  buffers[buffer].push_back(segment);
}

void PtMode::Clear(size_t buffer) {
  buffers[buffer].clear();
  if (!dynamic) return;
  buffers[1 - buffer].clear();
  write_buffer = 0;
  run_buffer = 0;
}

bool PtMode::HasData(size_t buffer) const { return dynamic ? !Empty() : !buffers[buffer].empty(); }

double PtMode::Direction(size_t buffer) const {
  for (const PtSegment& segment : buffers[dynamic ? run_buffer : buffer]) {
    if (segment.velocity != 0) return segment.velocity;
    if (segment.end_velocity != 0) return segment.end_velocity;
  }
  return 0;
}

size_t PtMode::Remainder() const {
  const size_t held = dynamic ? buffers[0].size() + buffers[1].size() : buffers[run_buffer].size();
  return running ? held - index - 1 : held;
}

void PtMode::Start(Micros now, const Sample& from) {
  running = true;
  index = 0;
  begin = now;
  origin = from.position;
  loop_count = 0;
  number = buffers[run_buffer].front().number;
}

bool PtMode::NextBuffer() {
  index = 0;
  if (dynamic) {
    buffers[run_buffer].clear();
    run_buffer = 1 - run_buffer;
    return !buffers[run_buffer].empty();
  }
  const PtSegment& end = buffers[run_buffer].back();
  begin += Micros{end.end_time} * 1000;
  origin += end.end;
  ++loop_count;
  return loop_target == 0 || loop_count < loop_target;
}

Sample PtMode::At(Micros now) {
  while (MsBetween(begin, now) >= buffers[run_buffer][index].end_time) {
    const double reached = origin + buffers[run_buffer][index].end;
    ++index;
    if (index == buffers[run_buffer].size() && !NextBuffer()) {
      Halt();
      return AtRest(reached);
    }
    number = buffers[run_buffer][index].number;
  }
  const PtSegment& segment = buffers[run_buffer][index];
  const double t = MsBetween(begin, now) - segment.begin_time;
  const double acceleration =
      (segment.end_velocity - segment.velocity) / (segment.end_time - segment.begin_time);
  return {origin + segment.begin + t * (segment.velocity + t * (acceleration / 2)),
          segment.velocity + t * acceleration, acceleration, true};
}

void PtMode::Halt() {
  if (!running) return;
  running = false;
  if (dynamic) Clear(0);
}

}  // namespace oncard::motion
