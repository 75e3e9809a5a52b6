// The state of a motion core: plain data, so that a snapshot is a copy. The headers of its parts
// say what they are; motion_core.h says how it advances.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "motion/axis.h"
#include "motion/bus_axis.h"
#include "motion/common/card_defaults.h"
#include "motion/common/rare.h"
#include "motion/common/sizes.h"
#include "motion/compensation.h"
#include "motion/control.h"
#include "motion/encoder.h"
#include "motion/gantry.h"
#include "motion/homing.h"
#include "motion/input_shaper.h"
#include "motion/io/analog.h"
#include "motion/io/capture.h"
#include "motion/io/compare.h"
#include "motion/io/digital_io.h"
#include "motion/io/extension.h"
#include "motion/io/laser.h"
#include "motion/mechanics/plant.h"
#include "motion/mechanics/switches_and_marks.h"
#include "motion/mechanics/world_events.h"
#include "motion/paths/crd.h"
#include "motion/profiles/profile.h"
#include "motion/profiles/pvt_table.h"

namespace oncard::motion {

/// What the drive and the mechanics of an axis can follow. The card does not know it and plans
/// beyond it.
struct DriveLimits {
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  double velocity = kNone;      ///< pulse/ms, > 0
  double acceleration = kNone;  ///< pulse/ms^2, > 0

  bool any() const { return velocity < kNone || acceleration < kNone; }
};

/// Sizes and timing of a card, and what its drives can follow.
struct MotionConfig {
  int axis_count = 8;      ///< 1 to kAxisMax
  int64_t cycle_us = 250;  ///< profile cycle; a multiple of servo_us, at most 4000
  int64_t servo_us = 125;  ///< servo sub-step
  CardDefaults defaults = {};
  std::array<DriveLimits, kAxisMax> drive_limits = {};

  double ServoMs() const { return static_cast<double>(servo_us) / 1000; }
};

/// True if the card has auxiliary encoders (sizes.h).
constexpr bool HasAuxiliary(const MotionConfig& config) {
  return config.defaults.auxiliary_encoders &&
         static_cast<size_t>(config.axis_count) <= kAuxiliaryFirst;
}

struct MotionState {
  int64_t cycle = 0;        ///< profile cycles since power-on
  int64_t clock_cycle = 0;  ///< profile cycles since the last GT_Reset
  DigitalIo io;
  std::array<Profile, kAxisMax> profiles;
  std::array<PvtTablePointer, kPvtTableCount> pvt_tables;
  std::array<Crd, kCrdCount> crds;
  std::array<Axis, kAxisMax> axes;
  /// Configuration: the axis that an enable output follows, from 0; -1: none.
  std::array<int8_t, kAxisIoWidth> enable_axes{};
  std::array<Compensation, kAxisMax> compensations;
  bool compensates = false;  ///< any of them
  std::array<Encoder, kAxisMax> encoders;
  std::array<EncoderFault, kAxisMax> encoder_faults;
  std::array<Drive, kAxisMax> drives;
  std::array<Plant, kAxisMax> plants;
  std::array<Step, kAxisMax> steps;
  std::array<Control, kAxisMax> controls;
  std::array<Dac, kAxisMax> dacs;
  std::array<Adc, kAdcCount> adcs;
  std::array<ExtensionModule, kModuleCount> modules;
  WorldProgress world;
  std::vector<PositionSwitch> switches;
  std::array<IndexMarks, kAxisMax> index_marks;
  CaptureUnit capture;
  CompareUnit compare;
  Lasers lasers;
  Gantry gantry;
  std::array<Homing, kAxisMax> homing;
  bool homing_runs = false;  ///< any of them
  /// BufferedKind::kOutside commands that paths have reached, in their order. The owner of the core
  /// carries them out after the tick and empties the list; it gives it the capacity of a FIFO
  /// before it appends the first such command, so that a tick allocates nothing.
  std::vector<BufferedCommand> reached;
  Rare<BusPart> bus;
  /// Of all axes, if one of them is on.
  Rare<std::array<InputShaper, kAxisMax>> shapers;
  /// The analogue output of a spindle, beside those of the axes: of cards whose CardDefaults say
  /// so. No servo controller writes it.
  Rare<Dac> spindle;

  auto Fields(auto visit) const {
    return visit(cycle, clock_cycle, io, profiles, pvt_tables, crds, axes, enable_axes,
                 compensations, compensates, encoders, encoder_faults, drives, plants, steps,
                 controls, dacs, adcs, modules, world, switches, index_marks, capture, compare,
                 lasers, gantry, homing, homing_runs, reached, bus, shapers, spindle);
  }
};

}  // namespace oncard::motion
