// The two touch probes of a drive: objects 60B8h to 60BDh. An edge of a probe input captures the
// position at its instant. A captured edge stays in the status until the probe is disabled; in
// continuous mode each further edge captures again and toggles a bit (CiA 402-2; GTHD: bit 6).
// Tested by tests/motion/bus/touch_probes_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/bus/objects.h"

namespace oncard::motion::bus {

inline constexpr size_t kProbeCount = 2;

/// Bits of 60B8h for probe 1; those of probe 2 are 8 higher.
inline constexpr uint16_t kProbeEnable = 1u << 0;
inline constexpr uint16_t kProbeContinuous = 1u << 1;
inline constexpr uint16_t kProbeRising = 1u << 4;
inline constexpr uint16_t kProbeFalling = 1u << 5;
/// Bits of 60B9h in the same way.
inline constexpr uint16_t kProbeEnabled = 1u << 0;
inline constexpr uint16_t kProbeRisen = 1u << 1;
inline constexpr uint16_t kProbeFallen = 1u << 2;
inline constexpr uint16_t kProbeRisenAgain = 1u << 6;
/// Assumption: the toggle of falling edges is the next bit.
inline constexpr uint16_t kProbeFallenAgain = 1u << 7;

struct TouchProbes {
  std::array<bool, kProbeCount> levels{};  ///< of the inputs

  /// Takes the present function: a probe that is disabled forgets what it has captured.
  static void TakeFunction(ObjectValues& values);
  /// True if that would change nothing.
  static bool HasTakenFunction(const ObjectValues& values);
  /// The input of a probe has a new level, while the drive was at `position`.
  void Edge(size_t probe, bool level, int64_t position, ObjectValues& values);

  auto Fields(auto visit) const { return visit(levels); }
};

}  // namespace oncard::motion::bus
