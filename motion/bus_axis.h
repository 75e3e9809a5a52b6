// What a card keeps for its axes on a bus, beside the bus itself. Units: pulses of the card, which
// are counts of the drive's encoder divided by 2^scale. Source: GTS manual S2, chapter 5. Tested by
// tests/motion/bus/bus_axes_test.cc.
#pragma once

#include <array>
#include <cstdint>

#include "motion/bus/bus.h"
#include "motion/common/sizes.h"

namespace oncard::motion {

/// Homing by the drive, as the controller commands it.
enum class BusHoming : uint8_t {
  kNone,
  kArmed,  ///< begins with the next cycle, so that the drive sees an edge
  kRuns
};

/// Bits of GT_GetEcatHomingStatus.
inline constexpr uint16_t kHomingFinished = 1u << 0;
inline constexpr uint16_t kHomingSucceeded = 1u << 1;
inline constexpr uint16_t kHomingFailed = 1u << 2;

/// The controller's side of an axis with a drive on the bus.
struct BusAxis {
  int8_t slave = -1;          ///< the slave with its drive, from 0; -1: not on the bus
  bool enable = false;        ///< GT_AxisOn
  bool resets_fault = false;  ///< GT_ClrSts while the drive had a fault
  BusHoming homing = BusHoming::kNone;
  bool homing_prepared = false;  ///< GT_SetEcatHomingPrm
  uint16_t homing_status = 0;
  uint8_t scale = 0;     ///< GT_SetPosScale: exponent of 2
  bool alarm = false;    ///< the drive has a fault, or the bus does not reach it
  bool follows = false;  ///< planned positions are the drive's target (mode 8)
  double lead = 0;       ///< target minus planned position, pulses
  int32_t raw = 0;       ///< 6064h in the last exchange
  double counts = 0;     ///< the same without wrapping

  bool on_bus() const { return slave >= 0; }
  double unit() const { return static_cast<double>(uint32_t{1} << scale); }
  /// The measured position, pulses, with fractions.
  double feedback() const { return counts / unit(); }

  auto Fields(auto visit) const {
    return visit(slave, enable, resets_fault, homing, homing_prepared, homing_status, scale, alarm,
                 follows, lead, raw, counts);
  }
};

/// The bus of a card with the axes on it.
struct BusPart {
  bus::Bus line;
  std::array<BusAxis, kAxisMax> axes;

  auto Fields(auto visit) const { return visit(line, axes); }
};

}  // namespace oncard::motion
