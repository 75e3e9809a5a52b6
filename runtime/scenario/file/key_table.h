// Describes the keys of scenario files, each in one row: its name, type and range, what it means,
// which commands use it, and the member that holds it. Reading, writing (keyed_toml.h), the table
// of uses (scenario_keys.h), the tables of docs/scenarios.md and the schema for editors
// (scenario_schema.h) follow from the rows. What depends on several keys is a function of the
// reader. Rows: key_rows.cc, world_key_rows.cc, bus_key_rows.cc, view_key_rows.cc. Tested by
// tests/runtime/key_table_test.cc.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/message.h"
#include "runtime/scenario/file/scenario.h"

namespace oncard::runtime {

/// A constant text in both languages.
struct Words {
  std::string_view en;
  std::string_view zh;
};

/// What a number that is missing counts as.
inline constexpr Words kZero = {"0", "0"};

enum class KeyKind : uint8_t {
  kText,
  kTexts,   ///< a list
  kChoice,  ///< one of some texts
  kCard,    ///< the name of a type of card
  kAxes,    ///< a number of axes that a type of card has
  kWhole,
  kNumber,
  kNumbers,  ///< a list
  kFlag,
  kTime,        ///< in ms, from 0 to kTimeMsMax
  kTimes,       ///< two of them, the earlier one first
  kLevel,       ///< a whole number, or "any"
  kValues,      ///< a table of variables: each a number or a list of numbers
  kOpenValues,  ///< the same, or whole numbers of which one is chosen
  kTable,       ///< one table of its own section
  kTables,      ///< several
  kEither,      ///< one table of its own section, or several of another one
  kWish         ///< "prove", or a table of its own section
};

/// The values that a key can have. What a command cannot know without the program, or what depends
/// on other keys, can narrow them.
struct KeyType {
  KeyKind kind = KeyKind::kText;
  double smallest = 0;
  double largest = 0;
  int64_t step = 1;                                ///< kWhole: a multiple of it
  size_t count = 0;                                ///< kNumbers: at most so many
  std::span<const std::string_view> choices = {};  ///< kChoice
  /// KeySection::path of kTable, kTables, kWish, and of the one table of kEither.
  std::string_view section = {};
  std::string_view several = {};  ///< kEither: that of the tables
  /// kNumber: in pulses and milliseconds, or in the unit of an axis that has one.
  std::optional<AxisMeasure> measure = {};

  static constexpr KeyType Text() { return {}; }
  static constexpr KeyType Texts() { return {.kind = KeyKind::kTexts}; }
  static constexpr KeyType Choice(std::span<const std::string_view> choices) {
    return {.kind = KeyKind::kChoice, .choices = choices};
  }
  static constexpr KeyType Card() { return {.kind = KeyKind::kCard}; }
  static constexpr KeyType Axes() {
    return {.kind = KeyKind::kAxes, .smallest = 1, .largest = motion::kAxisMax};
  }
  static constexpr KeyType Whole(int64_t smallest, int64_t largest, int64_t step = 1) {
    return {.kind = KeyKind::kWhole,
            .smallest = static_cast<double>(smallest),
            .largest = static_cast<double>(largest),
            .step = step};
  }
  /// Counts something of the file, from 1.
  static constexpr KeyType Ordinal() {
    return {
        .kind = KeyKind::kWhole, .smallest = 1, .largest = std::numeric_limits<double>::infinity()};
  }
  static constexpr KeyType Number(double smallest, double largest) {
    return {.kind = KeyKind::kNumber, .smallest = smallest, .largest = largest};
  }
  static constexpr KeyType Measured(AxisMeasure measure, double smallest, double largest) {
    KeyType type = Number(smallest, largest);
    type.measure = measure;
    return type;
  }
  static constexpr KeyType Numbers(size_t count, double smallest, double largest) {
    return {.kind = KeyKind::kNumbers, .smallest = smallest, .largest = largest, .count = count};
  }
  static constexpr KeyType Flag() { return {.kind = KeyKind::kFlag}; }
  static constexpr KeyType Time() { return {.kind = KeyKind::kTime}; }
  static constexpr KeyType Times() { return {.kind = KeyKind::kTimes}; }
  static constexpr KeyType Level(int64_t largest) {
    return {.kind = KeyKind::kLevel, .largest = static_cast<double>(largest)};
  }
  static constexpr KeyType Values() { return {.kind = KeyKind::kValues}; }
  static constexpr KeyType OpenValues() { return {.kind = KeyKind::kOpenValues}; }
  static constexpr KeyType Table(std::string_view section) {
    return {.kind = KeyKind::kTable, .section = section};
  }
  static constexpr KeyType Tables(std::string_view section) {
    return {.kind = KeyKind::kTables, .section = section};
  }
  static constexpr KeyType Either(std::string_view section, std::string_view several) {
    return {.kind = KeyKind::kEither, .section = section, .several = several};
  }
  static constexpr KeyType Wish(std::string_view section) {
    return {.kind = KeyKind::kWish, .section = section};
  }
};

/// How the commands treat a top-level key.
struct KeyUses {
  KeyUse run = KeyUse::kUsed;
  KeyUse explore = KeyUse::kUsed;
  KeyUse host = KeyUse::kUsed;
};

/// A key for readers of documents and schemas.
struct KeyDescription {
  std::string_view name;
  KeyType type = {};
  Words meaning = {};   ///< with its unit, in Markdown
  Words standard = {};  ///< what holds without it; empty: it is required
  KeyUses uses = {};

  bool required() const { return standard.en.empty(); }
};

/// The member of a structure that holds a key.
template <typename Structure>
using KeyMember =
    std::variant<std::monostate, std::string Structure::*, std::vector<std::string> Structure::*,
                 int Structure::*, int64_t Structure::*, double Structure::*, bool Structure::*,
                 std::optional<int64_t> Structure::*, std::vector<InitialValue> Structure::*>;

/// A key with its place in the structure.
template <typename Structure>
struct Key {
  KeyDescription about;
  KeyMember<Structure> member = {};  ///< none: the section's reader and writer take care of it
  /// Written although it has its standard value.
  bool always_written = false;
};

/// The keys of each table, in the order of the documentation and of a file that is written.
std::span<const Key<Scenario>> ScenarioKeys();
std::span<const Key<TimedResponse>> WithinKeys();
std::span<const Key<ExploreWish>> WishKeys();
std::span<const Key<ThreadStart>> ThreadKeys();
std::span<const Key<HostProgram>> HostProgramKeys();
std::span<const Key<HostEvent>> HostKeys();
std::span<const Key<KeyPress>> PressKeys();
std::span<const Key<World>> WorldKeys();
std::span<const Key<InputEvent>> InputKeys();
std::span<const Key<InputReaction>> ReactionKeys();
std::span<const Key<MotorSetup>> MotorKeys();
std::span<const Key<SwitchSetup>> SwitchKeys();
std::span<const Key<SwitchMove>> MoveKeys();
std::span<const Key<WorldFault>> FaultKeys();
std::span<const Key<HandTurn>> HandKeys();
std::span<const Key<VoltageEvent>> VoltageKeys();
std::span<const Key<ModuleEvent>> ModuleKeys();
std::span<const Key<ViewSetup>> ViewKeys();
std::span<const Key<ViewPin>> ViewPinKeys();
std::span<const Key<BusSetup>> BusKeys();
std::span<const Key<BusSlaveSetup>> BusSlaveKeys();
/// Those of them that an ENI file can describe.
std::span<const Key<BusSlaveSetup>> ConfiguredSlaveKeys();
std::span<const Key<BusInputEvent>> BusInputKeys();

/// A table of a scenario file with its keys.
struct KeySection {
  std::string_view path;  ///< `thread`, `world.input`; empty: the file
  std::vector<KeyDescription> keys;
};

/// All of them; KeyType::section names one.
std::vector<KeySection> KeySections();

}  // namespace oncard::runtime
