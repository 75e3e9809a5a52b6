// The tables of catalogue.h, made from the .def files at compile time. What the machine must know
// of each command (vm::CommandShape) is derived from the same rows. Tested by
// tests/gtcalls/catalogue_test.cc.
#include "gtcalls/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gtcalls/gts/rows.h"

namespace oncard::gtcalls {
namespace {

constexpr Constant kConstants[] = {
#define CONSTANT(name, value) {#name, value},
#include "gtcalls/gts/constants.def"
};

/// Who may call a command: the third column of catalogue.def.
enum class Callers : uint8_t { kHost, kProgram, kBoth };

// Rows stand in the order of their topics; the tables in the order of their numbers.
constexpr auto kCommands = [] {
  using namespace gts::words;
  auto commands = std::to_array({
#define COMMAND(number, name, tier, callers, cost, touching, brief, source, ...) \
  Command{number,                                                                \
          #name,                                                                 \
          Family::kGts,                                                          \
          Tier::k##tier,                                                         \
          Callers::callers != Callers::kHost,                                    \
          Callers::callers != Callers::kProgram,                                 \
          Cost::cost,                                                            \
          gts::rows::name##Accesses,                                             \
          gts::rows::name,                                                       \
          brief,                                                                 \
          source},
#include "gtcalls/gts/catalogue.def"
  });
  std::sort(commands.begin(), commands.end(),
            [](const Command& a, const Command& b) { return a.number < b.number; });
  return commands;
}();

// Numbers run from 1 without gaps, so that a number is also an index.
constexpr bool NumberedFromOne() {
  for (size_t i = 0; i < kCommands.size(); ++i) {
    if (kCommands[i].number != i + 1) return false;
  }
  return true;
}
static_assert(NumberedFromOne());

// --- Shapes -------------------------------------------------------------------------------------

constexpr vm::DataType kIntSlot[] = {vm::DataType::kInt};
constexpr vm::DataType kDoubleSlot[] = {vm::DataType::kDouble};

constexpr size_t CountCells(const Structure& structure) {
  size_t count = 0;
  words::ForEachCell(structure, [&](Scalar) { ++count; });
  return count;
}

template <size_t size>
constexpr std::array<vm::DataType, size> SlotsOf(const Structure& structure) {
  std::array<vm::DataType, size> slots{};
  size_t next = 0;
  words::ForEachCell(structure, [&](Scalar type) { slots[next++] = ProgramType(type); });
  return slots;
}

/// The slots behind each structure, named like it.
namespace structure_slots {
#define STRUCTURE(name, ...) \
  constexpr auto name = SlotsOf<CountCells(gts::structures::name)>(gts::structures::name);
#include "gtcalls/gts/structures.def"
}  // namespace structure_slots

constexpr std::span<const vm::DataType> SlotsBehind(const Structure* structure) {
#define STRUCTURE(name, ...) \
  if (structure == &gts::structures::name) return structure_slots::name;
#include "gtcalls/gts/structures.def"
  return {};
}

constexpr vm::ParameterShape ShapeOfParameter(const Parameter& parameter) {
  vm::ParameterShape shape;
  shape.name = parameter.name;
  shape.address = parameter.passing != Passing::kValue;
  shape.count_parameter = parameter.count_parameter;
  shape.elements_on_card = parameter.per_dimension || parameter.per_offset;
  if (parameter.structure != nullptr) {
    shape.slots = SlotsBehind(parameter.structure);
  } else if (parameter.type != Scalar::kChar) {
    shape.slots = ProgramType(parameter.type) == vm::DataType::kDouble ? kDoubleSlot : kIntSlot;
  }
  return shape;
}

template <size_t size>
constexpr std::array<vm::ParameterShape, size> ShapesOf(
    const std::array<Parameter, size>& parameters) {
  std::array<vm::ParameterShape, size> shapes;
  std::transform(parameters.begin(), parameters.end(), shapes.begin(), ShapeOfParameter);
  return shapes;
}

/// The parameters' shapes of each command, named like it.
namespace parameter_shapes {
#define COMMAND(number, name, ...) constexpr auto name = ShapesOf(gts::rows::name);
#include "gtcalls/gts/catalogue.def"
}  // namespace parameter_shapes

constexpr auto kShapes = [] {
  auto shapes = std::to_array({
#define COMMAND(number, name, tier, callers, ...) \
  vm::CommandShape{number, #name, parameter_shapes::name, Callers::callers != Callers::kHost},
#include "gtcalls/gts/catalogue.def"
  });
  std::sort(shapes.begin(), shapes.end(), [](const vm::CommandShape& a, const vm::CommandShape& b) {
    return a.number < b.number;
  });
  return shapes;
}();

// --- Names --------------------------------------------------------------------------------------

// Pointers into `table`, sorted by name.
template <typename Row, size_t size>
std::array<const Row*, size> SortByName(const std::array<Row, size>& table) {
  std::array<const Row*, size> index;
  std::transform(table.begin(), table.end(), index.begin(), [](const Row& row) { return &row; });
  std::sort(index.begin(), index.end(),
            [](const Row* a, const Row* b) { return a->name < b->name; });
  return index;
}

}  // namespace

std::span<const Command> Commands() { return kCommands; }

const Command* FindCommand(std::string_view name) {
  static const auto kByName = SortByName(kCommands);
  const auto found = std::lower_bound(
      kByName.begin(), kByName.end(), name,
      [](const Command* command, std::string_view key) { return command->name < key; });
  return found != kByName.end() && (*found)->name == name ? *found : nullptr;
}

const Command* FindCommand(uint16_t number) {
  return number >= 1 && number <= kCommands.size() ? &kCommands[number - 1u] : nullptr;
}

const vm::CommandShape& ShapeOf(const Command& command) { return kShapes[command.number - 1u]; }

std::span<const Structure> Structures() { return gts::structures::Table::kRows; }

const Structure* FindStructure(std::string_view name) {
  const auto found = std::ranges::find(gts::structures::Table::kRows, name, &Structure::name);
  return found != std::end(gts::structures::Table::kRows) ? found : nullptr;
}

std::span<const Constant> Constants() { return kConstants; }

const Constant* FindConstant(std::string_view name) {
  const auto found = std::ranges::find(kConstants, name, &Constant::name);
  return found != std::end(kConstants) ? found : nullptr;
}

int CellCount(const Structure& structure) { return static_cast<int>(CountCells(structure)); }

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
    case Scalar::kLong:
      return "long";
    case Scalar::kUnsignedLong:
      return "unsigned long";
    case Scalar::kDouble:
      break;
  }
  return "double";
}

std::string DeclareParameter(const Parameter& parameter) {
  const std::string_view type =
      parameter.structure != nullptr ? parameter.structure->name : SpellScalar(parameter.type);
  switch (parameter.passing) {
    case Passing::kValue:
      return fmt::format("{} {}", type, parameter.name);
    case Passing::kText:
      return fmt::format("const char *{}", parameter.name);
    case Passing::kTextOutput:
      return fmt::format("char **{}", parameter.name);
    case Passing::kInput:
    case Passing::kOutput:
    case Passing::kLent:
      break;
  }
  return fmt::format("{} *{}", type, parameter.name);
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
    case Unit::kVolt:
      return "V";
    case Unit::kPercent:
      return "%";
    case Unit::kMask:
      return "bit n-1: number n";
    case Unit::kBits:
      break;
  }
  return "bits";
}

namespace {

/// A range that its number does not belong to is written with the nearest number inside: `bound` is
/// such a one when the number next to it on the way to `outwards` is whole and it is not.
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
