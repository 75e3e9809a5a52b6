// The notation of a family's .def files. All of it is evaluated by the compiler; a row with the
// name of a parameter that it does not have fails to compile. A family adds its own notation, with
// its limits (gts/words.h), and includes rows.inc, which turns the rows into constants.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "gtcalls/catalogue.h"

namespace oncard::gtcalls::words {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Who may call a command: a column of catalogue.def. Commands that the host library itself answers
/// (kLibrary) can only be called by a host.
enum class Callers : uint8_t { kHost, kLibrary, kProgram, kBoth };

constexpr bool AreHosts(Callers callers) { return callers != Callers::kProgram; }
constexpr bool ArePrograms(Callers callers) {
  return callers == Callers::kProgram || callers == Callers::kBoth;
}

// --- Structures ---------------------------------------------------------------------------------

/// The notation of structures.def.
namespace members {

constexpr Member Char(std::string_view name, int size) { return {name, Scalar::kChar, size}; }
constexpr Member Short(std::string_view name, int size = 0) { return {name, Scalar::kShort, size}; }
constexpr Member UShort(std::string_view name, int size = 0) {
  return {name, Scalar::kUnsignedShort, size};
}
constexpr Member Int(std::string_view name, int size = 0) { return {name, Scalar::kInt, size}; }
constexpr Member Long(std::string_view name, int size = 0) { return {name, Scalar::kLong, size}; }
constexpr Member ULong(std::string_view name) { return {name, Scalar::kUnsignedLong}; }
constexpr Member Double(std::string_view name, int size = 0) {
  return {name, Scalar::kDouble, size};
}
constexpr Member Pointer(Scalar type, std::string_view name) { return {name, type, 0, true}; }
constexpr Member Nested(const Structure& structure, std::string_view name, int size = 0) {
  return {name, Scalar::kShort, size, false, &structure};
}

}  // namespace members

/// Calls `visit(type)` for every cell of a structure, in the order of its members.
template <typename Visit>
constexpr void ForEachCell(const Structure& structure, const Visit& visit) {
  for (const Member& member : structure.members) {
    for (int i = 0; i < std::max(member.array_size, 1); ++i) {
      if (member.structure != nullptr) {
        ForEachCell(*member.structure, visit);
      } else if (!member.pointer && member.type != Scalar::kChar) {
        visit(member.type);
      }
    }
  }
}

// --- Parameters ---------------------------------------------------------------------------------

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
  /// Inclusive; for an excluded limit pass the nearest number inside.
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
  /// A pointer to a structure of pointers to arrays, which are filled.
  constexpr Spec HostMemory() const { return Passed(Passing::kHostMemory); }
  /// The number of elements is the value of the parameter with this name.
  constexpr Spec Elements(std::string_view count) const {
    Spec changed = *this;
    changed.count_name = count;
    return changed;
  }
  /// The pointer refers to that many scalars.
  constexpr Spec Array(int size) const {
    Spec changed = *this;
    changed.parameter.array_size = size;
    return changed;
  }
  constexpr Spec PerDimension() const {
    Spec changed = *this;
    changed.parameter.per_dimension = true;
    return changed;
  }
  constexpr Spec PerAxis() const {
    Spec changed = *this;
    changed.parameter.per_axis = true;
    return changed;
  }
  constexpr Spec PerOffset() const {
    Spec changed = *this;
    changed.parameter.per_offset = true;
    return changed;
  }
  /// An output that is also written when the command is refused.
  constexpr Spec OnRefusal() const {
    Spec changed = Output();
    changed.parameter.on_refusal = true;
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
constexpr Spec Int(std::string_view name) { return Scalars(Scalar::kInt, name); }
/// A value of an enumeration of the header.
constexpr Spec Enumeration(std::string_view type, std::string_view name) {
  Spec spec = Int(name);
  spec.parameter.type_name = type;
  return spec;
}
constexpr Spec Long(std::string_view name) { return Scalars(Scalar::kLong, name); }
constexpr Spec ULong(std::string_view name) { return Scalars(Scalar::kUnsignedLong, name); }
constexpr Spec Double(std::string_view name) { return Scalars(Scalar::kDouble, name); }
constexpr Spec Text(std::string_view name) { return Scalars(Scalar::kChar, name, Passing::kText); }
constexpr Spec TextOutput(std::string_view name) {
  return Scalars(Scalar::kChar, name, Passing::kTextOutput);
}
/// A function of the host; the header declares its type.
constexpr Spec Handler(std::string_view type, std::string_view name) {
  Spec spec = Scalars(Scalar::kChar, name, Passing::kHandler);
  spec.parameter.type_name = type;
  return spec;
}
/// An event of the host; the header declares its type.
constexpr Spec Event(std::string_view type, std::string_view name) {
  return Handler(type, name).Passed(Passing::kHandle);
}
/// A function of the host that the command returns in place of its code; after all parameters.
constexpr Spec Returned(std::string_view type, std::string_view name) {
  return Handler(type, name).Passed(Passing::kResult);
}
/// Memory of the host of as many bytes as the parameter with the name `size` says; the header
/// declares the type of the pointer.
constexpr Spec Memory(std::string_view type, std::string_view name, std::string_view size) {
  Spec spec = UChar(name).Elements(size);
  spec.parameter.type_name = type;
  return spec;
}
constexpr Spec Struct(const Structure& structure, std::string_view name) {
  Spec spec = Short(name);
  spec.parameter.structure = &structure;
  return spec;
}

constexpr Spec Index(std::string_view name, double first, double last) {
  return Short(name).In(Unit::kIndex).Range(first, last);
}
constexpr Spec Mask() { return Long("mask").In(Unit::kMask); }
/// The number of consecutive elements or axes.
constexpr Spec Count(int maximum) { return Short("count").Range(1, maximum); }
constexpr Spec AxisCount(int maximum) {
  Spec spec = Count(maximum);
  spec.parameter.axis_count = true;
  return spec;
}
/// The time at which the values were taken.
constexpr Spec Clock() { return ULong("pClock").Output().In(Unit::kMillisecond).Optional(); }
// --- Accesses -----------------------------------------------------------------------------------

/// An access while its row is written; the names are those of parameters.
struct Touch {
  Resource resource;
  bool write;
  std::string_view selector;
  std::string_view count;
  bool mask;
  Part part = Part::kWhole;
  std::string_view detail = {};
  std::string_view detail_count = {};
  int first = 0;

  /// Only that part (catalogue.h).
  constexpr Touch Only(Part accessed, std::string_view parameter = {},
                       std::string_view parameter_count = {}) const {
    Touch changed = *this;
    changed.part = accessed;
    changed.detail = parameter;
    changed.detail_count = parameter_count;
    return changed;
  }
  /// Only the output with the number in a parameter; outputs count from `from`.
  constexpr Touch OnlyBit(std::string_view parameter, int from) const {
    Touch changed = Only(Part::kBit, parameter);
    changed.first = from;
    return changed;
  }
  /// Only the outputs that enable the axis in a parameter, which are in the word with that number.
  constexpr Touch OnlyEnableOutputs(std::string_view axis, int word) const {
    Touch changed = Only(Part::kEnableOutputs, axis);
    changed.first = word;
    return changed;
  }
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

/// The column of accesses while its row is written.
template <size_t size>
struct Column {
  std::array<Touch, size> touches;
  bool never_refused = false;

  /// No state of the card refuses the command, only its arguments can.
  constexpr Column NeverRefused() const { return {touches, true}; }
};

template <typename... Touches>
constexpr Column<sizeof...(Touches)> Touching(Touches... touches) {
  return {{touches...}};
}

/// The index of the parameter with that name; -1 for no name. For an unknown name it is out of
/// bounds, which is not allowed in a constant expression: the row does not compile.
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
constexpr std::array<Access, size> Accesses(const Column<size>& column,
                                            const std::array<Parameter, parameter_count>& all) {
  const std::array<Touch, size>& touches = column.touches;
  std::array<Access, size> accesses;
  for (size_t i = 0; i < size; ++i) {
    accesses[i] = {.resource = touches[i].resource,
                   .write = touches[i].write,
                   .selector = IndexOf(all, touches[i].selector),
                   .mask = touches[i].mask,
                   .count_parameter = IndexOf(all, touches[i].count),
                   .part = touches[i].part,
                   .detail = IndexOf(all, touches[i].detail),
                   .detail_count = IndexOf(all, touches[i].detail_count),
                   .first = touches[i].first};
  }
  return accesses;
}

}  // namespace oncard::gtcalls::words
