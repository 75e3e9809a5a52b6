#include "motion/bus/touch_probes.h"

namespace oncard::motion::bus {
namespace {

constexpr unsigned kProbeBits = 8;

/// The byte of a word that belongs to the probe.
uint32_t ByteOf(const ObjectValues& values, ObjectId id, size_t probe) {
  return static_cast<uint32_t>(values[id]) >> (kProbeBits * probe) & 0xFF;
}

void SetStatus(ObjectValues& values, size_t probe, uint32_t status) {
  const auto shift = static_cast<unsigned>(kProbeBits * probe);
  const auto word = static_cast<uint32_t>(values[ObjectId::kProbeStatus]);
  values.Set(ObjectId::kProbeStatus, (word & ~(uint32_t{0xFF} << shift)) | status << shift);
}

/// The status of a probe once it has taken its function.
uint32_t StatusWithFunction(const ObjectValues& values, size_t probe) {
  const bool enabled = (ByteOf(values, ObjectId::kProbeFunction, probe) & kProbeEnable) != 0;
  return enabled ? ByteOf(values, ObjectId::kProbeStatus, probe) | kProbeEnabled : 0;
}

constexpr ObjectId kCaptured[kProbeCount][2] = {
    {ObjectId::kProbe1Falling, ObjectId::kProbe1Rising},
    {ObjectId::kProbe2Falling, ObjectId::kProbe2Rising},
};

}  // namespace

void TouchProbes::TakeFunction(ObjectValues& values) {
  for (size_t probe = 0; probe < kProbeCount; ++probe) {
    SetStatus(values, probe, StatusWithFunction(values, probe));
  }
}

bool TouchProbes::HasTakenFunction(const ObjectValues& values) {
  for (size_t probe = 0; probe < kProbeCount; ++probe) {
    const uint32_t status = ByteOf(values, ObjectId::kProbeStatus, probe);
    if (StatusWithFunction(values, probe) != status) return false;
  }
  return true;
}

void TouchProbes::Edge(size_t probe, bool level, int64_t position, ObjectValues& values) {
  if (levels[probe] == level) return;
  levels[probe] = level;
  const uint32_t function = ByteOf(values, ObjectId::kProbeFunction, probe);
  const uint32_t status = ByteOf(values, ObjectId::kProbeStatus, probe);
  const bool waits =
      (function & kProbeEnable) != 0 && (function & (level ? kProbeRising : kProbeFalling)) != 0;
  if (!waits) return;
  const bool continuous = (function & kProbeContinuous) != 0;
  const uint32_t captured = level ? kProbeRisen : kProbeFallen;
  if ((status & captured) != 0 && !continuous) return;
  const uint32_t again = level ? kProbeRisenAgain : kProbeFallenAgain;
  SetStatus(values, probe, (status | captured | kProbeEnabled) ^ (continuous ? again : 0));
  values.Set(kCaptured[probe][level ? 1 : 0], position);
}

}  // namespace oncard::motion::bus
