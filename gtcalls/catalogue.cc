// Finds rows by name and formats them. Tested by tests/gtcalls/catalogue_test.cc.
#include "gtcalls/catalogue.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "gtcalls/rows/words.h"

namespace oncard::gtcalls {
namespace {

template <typename Row>
const Row* FindRow(std::span<const Row> rows, std::string_view name) {
  const auto found = std::ranges::find(rows, name, &Row::name);
  return found != rows.end() ? &*found : nullptr;
}

std::string_view NameOf(const Command* command) { return command->name; }

}  // namespace

Catalogue::Catalogue(const CatalogueTables& tables) : tables_(tables) {
  for (const Command& command : tables_.commands) by_name_.push_back(&command);
  std::ranges::sort(by_name_, {}, NameOf);
}

const Command* Catalogue::Find(std::string_view name) const {
  const auto found = std::ranges::lower_bound(by_name_, name, {}, NameOf);
  return found != by_name_.end() && (*found)->name == name ? *found : nullptr;
}

const Structure* Catalogue::FindStructure(std::string_view name) const {
  return FindRow(tables_.structures, name);
}

const Constant* Catalogue::FindConstant(std::string_view name) const {
  return FindRow(tables_.constants, name);
}

int CellCount(const Structure& structure) {
  int count = 0;
  words::ForEachCell(structure, [&](Scalar) { ++count; });
  return count;
}

std::vector<Scalar> ArraysOf(const Structure& structure) {
  std::vector<Scalar> types;
  for (const Member& member : structure.members) {
    for (int i = 0; i < std::max(member.array_size, 1); ++i) {
      if (member.pointer) types.push_back(member.type);
      if (member.structure == nullptr) continue;
      const std::vector<Scalar> nested = ArraysOf(*member.structure);
      types.insert(types.end(), nested.begin(), nested.end());
    }
  }
  return types;
}

// --- Spelling -----------------------------------------------------------------------------------

std::string_view SpellScalar(Scalar scalar) {
  switch (scalar) {
    case Scalar::kChar:
      return "char";
    case Scalar::kUnsignedChar:
      return "unsigned char";
    case Scalar::kShort:
      return "short";
    case Scalar::kUnsignedShort:
      return "unsigned short";
    case Scalar::kInt:
      return "int";
    case Scalar::kLong:
      return "long";
    case Scalar::kUnsignedLong:
      return "unsigned long";
    case Scalar::kDouble:
      break;
  }
  return "double";
}

std::string DeclareParameter(const Parameter& parameter, std::string_view (*spell)(Scalar scalar)) {
  std::string_view type =
      parameter.structure != nullptr ? parameter.structure->name : spell(parameter.type);
  const bool named = !parameter.type_name.empty();
  if (named) type = parameter.type_name;
  switch (parameter.passing) {
    case Passing::kValue:
    case Passing::kHandler:
    case Passing::kHandle:
    case Passing::kResult:
      return fmt::format("{}{}{}", type, type.ends_with('*') ? "" : " ", parameter.name);
    case Passing::kText:
      return fmt::format("const char *{}", parameter.name);
    case Passing::kTextOutput:
      return fmt::format("char **{}", parameter.name);
    case Passing::kInput:
    case Passing::kOutput:
    case Passing::kLent:
    case Passing::kHostMemory:
      break;
  }
  return fmt::format("{} {}{}", type, named ? "" : "*", parameter.name);
}

std::string_view SpellUnit(Unit unit) {
  switch (unit) {
    case Unit::kNone:
    case Unit::kIndex:
      return "";
    case Unit::kPulse:
      return "pulse";
    case Unit::kPulsePerMs:
      return "pulse/ms";
    case Unit::kPulsePerMs2:
      return "pulse/ms^2";
    case Unit::kPulsePerMs3:
      return "pulse/ms^3";
    case Unit::kPulsePerSt:
      return "pulse/ST";
    case Unit::kPulsePerSt2:
      return "pulse/ST^2";
    case Unit::kPulsePerSt3:
      return "pulse/ST^3";
    case Unit::kLengthUnit:
      return "length unit";
    case Unit::kLengthUnitPerSt:
      return "length unit/ST";
    case Unit::kLengthUnitPerSt2:
      return "length unit/ST^2";
    case Unit::kMillimetre:
      return "mm";
    case Unit::kMmPerS:
      return "mm/s";
    case Unit::kMmPerS2:
      return "mm/s^2";
    case Unit::kMillisecond:
      return "ms";
    case Unit::kMicrosecond:
      return "us";
    case Unit::kCycle:
      return "profile cycles";
    case Unit::kQuarterMs:
      return "250 us";
    case Unit::kEighthMs:
      return "125 us";
    case Unit::kKilohertz:
      return "kHz";
    case Unit::kVolt:
      return "V";
    case Unit::kPercent:
      return "%";
    case Unit::kCount:
      return "count";
    case Unit::kCountPerSecond:
      return "count/s";
    case Unit::kPerMille:
      return "1/1000 of the rated value";
    case Unit::kByte:
      return "byte";
    case Unit::kMask:
      return "bit n-1: number n";
    case Unit::kBits:
      break;
  }
  return "bits";
}

namespace {

/// A range whose limit is excluded has the nearest number inside it as its bound. True for such a
/// bound: it is not whole, but the next number towards `outwards` is.
bool IsOpenEnd(double bound, double outwards) {
  const double beyond = std::nextafter(bound, outwards);
  return bound != std::floor(bound) && beyond == std::floor(beyond);
}

}  // namespace

std::string SpellRange(const Parameter& parameter) {
  constexpr double kInfinity = words::kUnbounded;
  const double low = parameter.minimum;
  const double high = parameter.maximum;
  if (low == -kInfinity && high == kInfinity) return "";
  std::string text;
  if (low == -kInfinity) {
    text = "(-inf, ";
  } else if (IsOpenEnd(low, -kInfinity)) {
    text = fmt::format("({:.15g}, ", std::nextafter(low, -kInfinity));
  } else {
    text = fmt::format("[{:.15g}, ", low);
  }
  if (high == kInfinity) {
    text += "inf)";
  } else if (IsOpenEnd(high, kInfinity)) {
    text += fmt::format("{:.15g})", std::nextafter(high, kInfinity));
  } else {
    text += fmt::format("{:.15g}]", high);
  }
  return text;
}

}  // namespace oncard::gtcalls
