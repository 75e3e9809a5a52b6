#include "compiler/lowering/types.h"

#include <fmt/core.h>

#include <array>

namespace oncard::compiler::lowering {
namespace {

struct Row {
  std::string_view name;
  int bytes;
  int64_t minimum;
  int64_t maximum;
};

// By number of the enum. An unsigned int is kept with the bits of the int that holds it.
constexpr std::array<Row, 10> kRows = {{
    {"void", 1, 0, 0},
    {"bool", 1, 0, 1},
    {"char", 1, INT8_MIN, INT8_MAX},
    {"unsigned char", 1, 0, UINT8_MAX},
    {"short", 2, INT16_MIN, INT16_MAX},
    {"unsigned short", 2, 0, UINT16_MAX},
    {"int", 4, INT32_MIN, INT32_MAX},
    {"unsigned int", 4, INT32_MIN, INT32_MAX},
    {"double", 8, 0, 0},
    {"structure", 0, 0, 0},
}};

const Row& RowOf(BasicType type) { return kRows[static_cast<size_t>(type)]; }

}  // namespace

bool Fits(BasicType values, BasicType into) {
  if (values == into) return true;
  if (!IsInteger(values) || !IsInteger(into)) return false;
  const Row& from = RowOf(values);
  const Row& to = RowOf(into);
  return from.minimum >= to.minimum && from.maximum <= to.maximum;
}

int SizeOf(BasicType type) { return RowOf(type).bytes; }

int64_t ConvertInteger(int64_t value, BasicType type) {
  switch (type) {
    case BasicType::kBool:
      return value != 0 ? 1 : 0;
    case BasicType::kChar:
      return static_cast<int8_t>(value);
    case BasicType::kUnsignedChar:
      return static_cast<uint8_t>(value);
    case BasicType::kShort:
      return static_cast<int16_t>(value);
    case BasicType::kUnsignedShort:
      return static_cast<uint16_t>(value);
    default:
      return static_cast<int32_t>(value);
  }
}

std::string_view NameOf(BasicType type) { return RowOf(type).name; }

std::string JoinNames(std::string_view whole, std::string_view part) {
  return part.empty() ? std::string(whole) : fmt::format("{}_{}", whole, part);
}

std::string SpellSizes(const std::vector<int64_t>& dimensions) {
  std::string text;
  for (const int64_t size : dimensions) text += fmt::format("[{}]", size);
  return text;
}

}  // namespace oncard::compiler::lowering
