// The vocabulary in which catalogue.def, structures.def and constants.def are written, and their
// rows as constants: one array of parameters and one of accesses per command, named like it. All of
// it is evaluated by the compiler; a row that names a parameter it does not have fails to compile.
// Only catalogue.cc, the generator of gts.h (for basic_layouts.def) and the test that compares the
// header with the catalogue include this file.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

// --- Limits (GTS manual chapter 13 and table 4-4, unless noted) ---------------------------------

/// Axes, profiles, controllers, encoders and outputs are numbered from 1 to at most this; the card
/// at hand may have fewer, which the commands check.
inline constexpr int kAxisMax = 12;
/// Elements that one call of GT_GetEncPos or GT_GetSts reads.
inline constexpr int kReadMax = 8;
/// Assumption: the analogue inputs of an 8-axis card.
inline constexpr int kAdcMax = 8;
inline constexpr int kCrdMax = 2;
inline constexpr int kThreadLast = 31;
inline constexpr int kPageLast = 31;
/// Variables per call of GT_GetVarValue.
inline constexpr int kVariableMax = 6;
/// Words per call of GT_LoadPlcCommand.
inline constexpr int kLoadMax = 24;
inline constexpr double kPositionMax = 1073741823;
/// Assumption: the smallest value where the manuals say "> 0"; as motion::kRateMin.
inline constexpr double kAboveZero = 1e-9;
/// The open end of a range: the nearest double inside (..., 32767).
inline constexpr double kBelow32767 = 32767.0 - 0x1p-38;
inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();
/// GT_SetPosErr.
inline constexpr double kPositionErrorMax = 2147483648.0;
/// Assumption: the largest exponent of GT_SetKvffFilter; as motion::kKvffFilterMax.
inline constexpr int kKvffFilterMax = 8;
/// PVT tables and the points of one (GTS manual chapter 7).
inline constexpr int kPvtTableMax = 32;
inline constexpr int kPvtPointMax = 1024;
/// Assumption: numbers of GT_SetLongVar and GT_SetDoubleVar; as many as motion::kUserVariableCount.
inline constexpr int kUserVariableLast = 1023;
/// Assumption: extension modules are numbered from 0.
inline constexpr int kModuleLast = 15;
/// Assumption: analogue channels of an extension module; one less than motion::kModuleChannels.
inline constexpr int kModuleChannelLast = 7;

// --- Sources ------------------------------------------------------------------------------------

inline constexpr std::string_view kManual = "GTS manual ch. 13";
inline constexpr std::string_view kTable = "GTS manual table 10-2; public header";
inline constexpr std::string_view kTableAssumed = "GTS manual table 10-2; parameters assumed";
inline constexpr std::string_view kNamed = "named in the GTS manuals; public header";
inline constexpr std::string_view kNotes = "GTS application notes; public header";
inline constexpr std::string_view kCompiler = "accepted by the vendor's compiler; public header";
inline constexpr std::string_view kCompilerAssumed =
    "accepted by the vendor's compiler; parameters assumed";
inline constexpr std::string_view kHeader = "public header";
inline constexpr std::string_view kThreadHeader = "public header of the thread extensions";

// --- Structures and constants -------------------------------------------------------------------

/// Structures of the interface under their own names, and the words of structures.def.
namespace structures {

constexpr Member Char(std::string_view name, int size) { return {name, Scalar::kChar, size}; }
constexpr Member Short(std::string_view name, int size = 0) { return {name, Scalar::kShort, size}; }
constexpr Member UShort(std::string_view name, int size = 0) {
  return {name, Scalar::kUnsignedShort, size};
}
constexpr Member Long(std::string_view name, int size = 0) { return {name, Scalar::kLong, size}; }
constexpr Member ULong(std::string_view name) { return {name, Scalar::kUnsignedLong}; }
constexpr Member Double(std::string_view name, int size = 0) {
  return {name, Scalar::kDouble, size};
}
constexpr Member Pointer(Scalar type, std::string_view name) { return {name, type, 0, true}; }
constexpr Member Nested(const Structure& structure, std::string_view name) {
  return {name, Scalar::kShort, 0, false, &structure};
}

/// The position of each structure in the table.
enum Position : size_t {
#define STRUCTURE(name, ...) k##name,
#include "gtcalls/structures.def"
  kCount
};

/// All structures. Declared before it is filled in, so that a member can refer to the structure
/// that it nests.
struct Table {
  static const Structure kRows[kCount];
};

#define STRUCTURE(name, ...) inline constexpr const Structure& name = Table::kRows[k##name];
#include "gtcalls/structures.def"

#define STRUCTURE(name, in_motion_program, ...) \
  inline constexpr std::array name##Members = std::array{__VA_ARGS__};
#include "gtcalls/structures.def"

inline constexpr Structure Table::kRows[kCount] = {
#define STRUCTURE(name, in_motion_program, ...) {#name, name##Members, in_motion_program},
#include "gtcalls/structures.def"
};

/// Calls `visit(type)` for every cell of a structure, in the order of its members.
template <typename Visit>
constexpr void ForEachCell(const Structure& structure, const Visit& visit) {
  for (const Member& member : structure.members) {
    if (member.structure != nullptr) {
      ForEachCell(*member.structure, visit);
    } else if (!member.pointer && member.type != Scalar::kChar) {
      for (int i = 0; i < std::max(member.array_size, 1); ++i) visit(member.type);
    }
  }
}

}  // namespace structures

// --- Commands -----------------------------------------------------------------------------------

/// Parameters and accesses of the commands, named like the commands, and the words of
/// catalogue.def.
namespace rows {

using enum Resource;

/// A parameter while its row is written. Each method returns the changed copy.
struct Spec {
  Parameter parameter;
  std::string_view count_name;

  constexpr Spec In(Unit unit) const {
    Spec changed = *this;
    changed.parameter.unit = unit;
    return changed;
  }
  /// Inclusive; an open end is kBelow32767.
  constexpr Spec Range(double minimum, double maximum) const {
    Spec changed = *this;
    changed.parameter.minimum = minimum;
    changed.parameter.maximum = maximum;
    return changed;
  }
  constexpr Spec Default(std::string_view text) const {
    Spec changed = *this;
    changed.parameter.default_text = text;
    return changed;
  }
  constexpr Spec Passed(Passing passing) const {
    Spec changed = *this;
    changed.parameter.passing = passing;
    return changed;
  }
  /// A pointer that is read, or written.
  constexpr Spec Input() const { return Passed(Passing::kInput); }
  constexpr Spec Output() const { return Passed(Passing::kOutput); }
  /// A pointer to memory that the card does not need.
  constexpr Spec Lent() const { return Passed(Passing::kLent); }
  /// The number of elements is the value of the parameter with this name.
  constexpr Spec Elements(std::string_view count) const {
    Spec changed = *this;
    changed.count_name = count;
    return changed;
  }
  constexpr Spec PerDimension() const {
    Spec changed = *this;
    changed.parameter.per_dimension = true;
    return changed;
  }
  constexpr Spec PerOffset() const {
    Spec changed = *this;
    changed.parameter.per_offset = true;
    return changed;
  }
  constexpr Spec Nullable() const {
    Spec changed = *this;
    changed.parameter.nullable = true;
    return changed;
  }
  /// May be omitted: NULL by default.
  constexpr Spec Optional() const { return Nullable().Default("NULL"); }
};

constexpr Spec Scalars(Scalar type, std::string_view name, Passing passing = Passing::kValue) {
  Spec spec;
  spec.parameter.name = name;
  spec.parameter.type = type;
  spec.parameter.passing = passing;
  return spec;
}
constexpr Spec UChar(std::string_view name) { return Scalars(Scalar::kUnsignedChar, name); }
constexpr Spec Short(std::string_view name) { return Scalars(Scalar::kShort, name); }
constexpr Spec UShort(std::string_view name) { return Scalars(Scalar::kUnsignedShort, name); }
constexpr Spec Long(std::string_view name) { return Scalars(Scalar::kLong, name); }
constexpr Spec ULong(std::string_view name) { return Scalars(Scalar::kUnsignedLong, name); }
constexpr Spec Double(std::string_view name) { return Scalars(Scalar::kDouble, name); }
constexpr Spec Text(std::string_view name) { return Scalars(Scalar::kChar, name, Passing::kText); }
constexpr Spec TextOutput(std::string_view name) {
  return Scalars(Scalar::kChar, name, Passing::kTextOutput);
}
constexpr Spec Struct(const Structure& structure, std::string_view name) {
  Spec spec = Short(name);
  spec.parameter.structure = &structure;
  return spec;
}

constexpr Spec Index(std::string_view name, double first, double last) {
  return Short(name).In(Unit::kIndex).Range(first, last);
}
/// Axes, and resources of the same number: profiles, encoders, controllers, DACs, pulse outputs.
constexpr Spec Axis(std::string_view name) {
  Spec spec = Index(name, 1, kAxisMax);
  spec.parameter.axis_number = true;
  return spec;
}
/// An encoder of an axis, or an auxiliary one.
constexpr Spec Encoder(std::string_view name) {
  Spec spec = Index(name, 1, kAxisMax);
  spec.parameter.encoder_number = true;
  return spec;
}
constexpr Spec Crd() { return Index("crd", 1, kCrdMax); }
/// One of two buffers.
constexpr Spec Fifo() { return Index("fifo", 0, 1); }
constexpr Spec Thread() { return Index("thread", 0, kThreadLast); }
/// The thread whose variables are meant; -1: the globals.
constexpr Spec ThreadOrGlobals() { return Index("thread", -1, kThreadLast); }
/// One of two high-speed output channels.
constexpr Spec Channel(std::string_view name) { return Index(name, 0, 1); }
constexpr Spec Module() { return Index("mdl", 0, kModuleLast); }
constexpr Spec ModuleChannel() { return Index("chn", 0, kModuleChannelLast); }
constexpr Spec DiType(std::string_view name) { return Short(name).Range(0, 6); }
constexpr Spec DoType() { return Short("doType").Range(10, 12); }
constexpr Spec Mask() { return Long("mask").In(Unit::kMask); }
/// How many consecutive elements, or axes.
constexpr Spec Count(int maximum) { return Short("count").Range(1, maximum); }
constexpr Spec AxisCount(int maximum) {
  Spec spec = Count(maximum);
  spec.parameter.axis_count = true;
  return spec;
}
/// The time at which the values were taken.
constexpr Spec Clock() { return ULong("pClock").Output().In(Unit::kMillisecond).Optional(); }
constexpr Spec Position(std::string_view name) {
  return Long(name).In(Unit::kPulse).Range(-kPositionMax, kPositionMax);
}
/// Path velocity, acceleration and end velocity of a segment.
constexpr Spec SynVel() {
  return Double("synVel").In(Unit::kPulsePerMs).Range(kAboveZero, kBelow32767);
}
constexpr Spec SynAcc() {
  return Double("synAcc").In(Unit::kPulsePerMs2).Range(kAboveZero, kBelow32767);
}
constexpr Spec VelEnd() { return Double("velEnd").In(Unit::kPulsePerMs).Range(0, kBelow32767); }
constexpr Spec Deceleration(std::string_view name) {
  return Double(name).In(Unit::kPulsePerMs2).Range(kAboveZero, 32767);
}

/// An access while its row is written; names stand for parameters.
struct Touch {
  Resource resource;
  bool write;
  std::string_view selector;
  std::string_view count;
  bool mask;
};

constexpr Touch Reads(Resource resource, std::string_view selector = {},
                      std::string_view count = {}) {
  return {resource, false, selector, count, false};
}
constexpr Touch Writes(Resource resource, std::string_view selector = {},
                       std::string_view count = {}) {
  return {resource, true, selector, count, false};
}
constexpr Touch WritesMask(Resource resource, std::string_view selector) {
  return {resource, true, selector, {}, true};
}

template <typename... Touches>
constexpr std::array<Touch, sizeof...(Touches)> Touching(Touches... touches) {
  return {touches...};
}

/// The index of the parameter with that name; -1 for no name. A name that no parameter has is an
/// index out of bounds, which a constant expression must not have: the row does not compile.
template <size_t size>
constexpr int IndexOf(const std::array<Parameter, size>& parameters, std::string_view name) {
  if (name.empty()) return -1;
  size_t index = 0;
  while (parameters.at(index).name != name) ++index;
  return static_cast<int>(index);
}

template <typename... Specs>
constexpr std::array<Parameter, sizeof...(Specs)> Parameters(Specs... specs) {
  std::array<Parameter, sizeof...(Specs)> parameters = {specs.parameter...};
  const std::array<std::string_view, sizeof...(Specs)> count_names = {specs.count_name...};
  for (size_t i = 0; i < parameters.size(); ++i) {
    parameters[i].count_parameter = IndexOf(parameters, count_names[i]);
  }
  return parameters;
}

template <size_t size, size_t parameter_count>
constexpr std::array<Access, size> Accesses(const std::array<Touch, size>& touches,
                                            const std::array<Parameter, parameter_count>& all) {
  std::array<Access, size> accesses;
  for (size_t i = 0; i < size; ++i) {
    accesses[i] = {touches[i].resource, touches[i].write, IndexOf(all, touches[i].selector),
                   touches[i].mask, IndexOf(all, touches[i].count)};
  }
  return accesses;
}

#define COMMAND(number, name, tier, callers, cost, touching, brief, source, ...) \
  inline constexpr auto name = Parameters(__VA_ARGS__);                          \
  inline constexpr auto name##Accesses = Accesses(touching, name);
#include "gtcalls/catalogue.def"

}  // namespace rows
}  // namespace oncard::gtcalls
