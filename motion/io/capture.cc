#include "motion/io/capture.h"

#include <utility>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<Capture> && kFieldsComplete<Trigger>);

}  // namespace

bool SourceListens(CaptureSource source, size_t index, DiType type, int bit) {
  const int own = static_cast<int>(index);
  switch (source) {
    case CaptureSource::kHome:
      return type == DiType::kHome && bit == own;
    case CaptureSource::kProbe:
      return type == DiType::kGpi && bit == kProbeInput;
    case CaptureSource::kHomeGpi:
      return (type == DiType::kHome || type == DiType::kGpi) && bit == own;
    case CaptureSource::kNone:
    case CaptureSource::kIndex:
    case CaptureSource::kHsio0:
    case CaptureSource::kHsio1:
      break;
  }
  return false;
}

void Capture::SetRising(CaptureSource of, bool edge_rises) {
  rising = static_cast<uint16_t>(edge_rises ? rising | BitOf(of) : rising & ~BitOf(of));
}

void CaptureUnit::Reset() {
  captures_.fill({});
  triggers_.fill({});
  for (size_t i = 0; i < kAxisMax; ++i) {
    captures_[i].encoder = static_cast<uint8_t>(i);
    captures_[i].offset_source = static_cast<uint8_t>(i);
  }
  armed_ = false;
}

void CaptureUnit::Arm(size_t index, CaptureSource source) {
  Clear(index);
  Capture& capture = captures_[index];
  capture.source = source;
  // Reserved here, so that a cycle does not allocate.
  capture.positions.reserve(capture.repeat);
  capture.armed = true;
  armed_ = true;
}

void CaptureUnit::SetRepeat(size_t index, uint16_t repeat) {
  Capture& capture = captures_[index];
  capture.repeat = repeat;
  capture.positions.reserve(repeat);
  if (capture.positions.size() >= repeat) capture.armed = false;
}

void CaptureUnit::Clear(size_t index) {
  captures_[index].captured = false;
  captures_[index].positions.clear();
}

void CaptureUnit::SetOffsets(size_t index, std::vector<int32_t> offsets, int32_t loop) {
  Capture& capture = captures_[index];
  capture.offsets = std::move(offsets);
  capture.loop = loop;
  capture.offsets_used = 0;
  capture.loops_done = 0;
}

void CaptureUnit::LinkOffsets(size_t index, size_t source) {
  captures_[index].offset_source = static_cast<uint8_t>(source);
  captures_[index].offsets_used = 0;
  captures_[index].loops_done = 0;
}

void CaptureUnit::SetTrigger(size_t index, const Trigger& registers) {
  triggers_[index] = registers;
  triggers_[index].armed = true;
  armed_ = true;
}

void CaptureUnit::ClearTrigger(size_t index) {
  triggers_[index].armed = false;
  triggers_[index].done = false;
  triggers_[index].count = 0;
}

bool CaptureUnit::WaitsForIndex(size_t motor) const {
  const Capture& own = captures_[motor];
  if (own.armed && own.source == CaptureSource::kIndex) return true;
  for (const Trigger& t : triggers_) {
    if (t.armed && t.source == CaptureSource::kIndex && t.input == motor) return true;
  }
  return false;
}

void CaptureUnit::Take(size_t index, double position) {
  Capture& capture = captures_[index];
  capture.raw = position;
  capture.value = position + NextOffset(index);
  capture.captured = true;
  capture.positions.push_back(capture.value);
  capture.armed = capture.positions.size() < capture.repeat;
}

void CaptureUnit::TakeTrigger(size_t index, double position) {
  Trigger& trigger = triggers_[index];
  if (trigger.window_only && (position < trigger.first || position > trigger.last)) return;
  trigger.position = position + trigger.offset;
  ++trigger.count;
  if (trigger.count < trigger.loop) return;
  trigger.done = true;
  trigger.armed = false;
}

double CaptureUnit::NextOffset(size_t index) {
  Capture& capture = captures_[index];
  const Capture& list = captures_[capture.offset_source];
  const bool used_up = list.loop > 0 && capture.loops_done >= list.loop;
  if (used_up || capture.offsets_used >= list.offsets.size()) return 0;
  const double offset = list.offsets[capture.offsets_used++];
  if (capture.offsets_used == list.offsets.size()) {
    capture.offsets_used = 0;
    ++capture.loops_done;
  }
  return offset;
}

void CaptureUnit::CountArmed() {
  armed_ = false;
  for (size_t i = 0; i < kAxisMax; ++i) armed_ |= captures_[i].armed || triggers_[i].armed;
}

}  // namespace oncard::motion
