// The observable values of axes, profiles, encoders and the other numbered parts of a card: one
// table of names, units and readers for expectations, results, traces, plots and their help. A name
// consists of the part, its number from 1, and one of its values: `axis1.prfPos`. Tested by
// tests/runtime/motion_values_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "gtcalls/card.h"
#include "motion/motion_core.h"

namespace oncard::runtime {

/// How a number is printed and drawn.
enum class NumberForm : uint8_t {
  kWhole,       ///< an integer
  kFixedPoint,  ///< a double of a motion program
  kReal,        ///< a double
  kFlag,        ///< 0 or 1
};

enum class Unit : uint8_t { kNone, kPulse, kPulsePerMs, kPulsePerMs2, kVolt, kKilohertz };

/// The unit as text: "pulse", "pulse/ms", "pulse/ms²", "V", "kHz"; empty for none. `per_cycle`: of
/// a card whose commands count motion in cycles (Family::cycle_ns), "pulse/cycle" and so on.
std::string_view UnitName(Unit unit, bool per_cycle);

/// One value of every part of a kind.
struct MotionValue {
  std::string_view name;  ///< empty: the part itself is the value
  NumberForm form = NumberForm::kReal;
  Unit unit = Unit::kNone;
  double (*read)(const gtcalls::CardView& card, size_t index) = nullptr;
  /// What its numbers mean, from 0 on, with empty ones between; of a measure, none.
  std::span<const std::string_view> names = {};
};

/// MotionPart::first of a part of which a card has one: it has no number.
inline constexpr int kUnnumbered = -1;

/// A kind of part.
struct MotionPart {
  std::string_view name;  ///< of one, without its number
  /// How many parts of this kind the card has.
  size_t (*count)(const motion::MotionCore& core) = nullptr;
  std::span<const MotionValue> values;
  /// The number of the first one, as in commands; kUnnumbered if there is only one.
  int first = 1;
  /// Whether the card has the part with an index; if empty, it has all of them.
  bool (*has)(const motion::MotionCore& core, size_t index) = nullptr;
  /// Part n belongs to axis n, and is measured in its unit.
  bool of_axis = false;
};

/// The high-speed outputs `hsio0` and `hsio1`, which can change inside a cycle (Trace).
inline constexpr std::string_view kHsioPart = "hsio";

/// All kinds, in the order of the documentation.
std::span<const MotionPart> MotionParts();

/// The kind of this name, or nullptr.
const MotionPart* FindMotionPart(std::string_view name);
/// The part's value of this name, or nullptr.
const MotionValue* FindMotionValue(const MotionPart& part, std::string_view name);
/// The full name of a value: `axis1.prfPos`, `dac1`, `spindle.volts`.
std::string MotionValueName(const MotionPart& part, int number, std::string_view value);

}  // namespace oncard::runtime
