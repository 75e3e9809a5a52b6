#include "runtime/scenario/file/world_toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "base/milliseconds.h"
#include "motion/io/extension.h"
#include "runtime/conditions/condition.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/file/key_table.h"
#include "runtime/scenario/file/keyed_toml.h"

namespace oncard::runtime {
namespace {

template <typename Event>
void SortByTime(std::vector<Event>& events) {
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.at_us < b.at_us; });
}

/// A row with the range of its values in a unit.
KeyDescription InUnit(KeyDescription key, const AxisUnit& unit) {
  if (!key.type.measure) return key;
  key.type.smallest = unit.FromPulses(key.type.smallest, *key.type.measure);
  key.type.largest = unit.FromPulses(key.type.largest, *key.type.measure);
  return key;
}

/// The value of an input whose level is open.
constexpr std::string_view kAnyLevel = "any";

class WorldReader {
 public:
  WorldReader(int axis_count, TomlKeys& keys, WorldPlaces* places)
      : axis_count_(axis_count), keys_(keys), places_(*places) {}

  World Read(const toml::table& table) {
    ReadKeys(table, WorldKeys(), keys_, &world_);
    for (const toml::table* input : keys_.Tables(table, "world.input")) ReadInput(*input);
    for (const toml::table* react : keys_.Tables(table, "world.react")) ReadReaction(*react);
    for (const toml::table* motor : keys_.Tables(table, "world.axis")) ReadMotor(*motor);
    for (const toml::table* contact : keys_.Tables(table, "world.switch")) ReadSwitch(*contact);
    for (const toml::table* move : keys_.Tables(table, "world.move")) ReadMove(*move);
    for (const toml::table* fault : keys_.Tables(table, "world.fault")) ReadFault(*fault);
    for (const toml::table* hand : keys_.Tables(table, "world.hand")) ReadHand(*hand);
    for (const toml::table* voltage : keys_.Tables(table, "world.analog")) ReadVoltage(*voltage);
    for (const toml::table* module : keys_.Tables(table, "world.module")) ReadModule(*module);
    CheckInputs(table);
    SortInputs();
    SortByTime(world_.moves);
    SortByTime(world_.voltages);
    SortByTime(world_.modules);
    return std::move(world_);
  }

 private:
  void ReadInput(const toml::table& table) {
    InputEvent event;
    ReadKeys(table, InputKeys(), keys_, &event);
    ReadBetween(table, &event);
    event.any_level = table["value"].value_exact<std::string>() == kAnyLevel;
    if (event.any_level) {
      ReadPin(table, &event);
      Need(table, "index", {"any level is chosen for one input", "任意电平只能用于一个输入"});
    } else {
      ReadLevel(table, &event);
    }
    places_.inputs.push_back(keys_.PlaceOfValue(table, event.last_us ? "between_ms" : "value"));
    world_.inputs.push_back(event);
  }

  /// By time, with their places.
  void SortInputs() {
    std::vector<std::pair<InputEvent, TextPlace>> placed;
    for (size_t i = 0; i < world_.inputs.size(); ++i) {
      placed.emplace_back(world_.inputs[i], std::move(places_.inputs[i]));
    }
    std::ranges::stable_sort(placed, {}, [](const auto& event) { return event.first.at_us; });
    for (size_t i = 0; i < placed.size(); ++i) {
      std::tie(world_.inputs[i], places_.inputs[i]) = std::move(placed[i]);
    }
  }

  void ReadPin(const toml::table& table, InputEvent* event) {
    event->type = InputType(table, "gpi");
    event->index =
        static_cast<int>(keys_.Whole(table, "index", 0, 1, motion::DiWidth(event->type)));
  }

  void ReadLevel(const toml::table& table, InputEvent* event) {
    ReadPin(table, event);
    const int64_t highest =
        event->index == 0 ? (int64_t{1} << motion::DiWidth(event->type)) - 1 : 1;
    event->value = static_cast<uint32_t>(keys_.Whole(table, "value", -1, 0, highest));
    if (!table.contains("value")) {
      keys_.Fail(table.source(), {"'value' is missing: the level of the pin, 0 or 1",
                                  "缺少“value”：管脚电平，0 或 1"});
    }
  }

  void ReadReaction(const toml::table& table) {
    InputReaction reaction;
    ReadKeys(table, ReactionKeys(), keys_, &reaction);
    Need(table, "when", {"the condition, as in \"gpo[1] == 1\"", "条件，如 \"gpo[1] == 1\""});
    if (table["when"].is_string()) {
      const auto condition = ParseCondition(reaction.when);
      if (!condition.ok()) keys_.Fail(table.get("when")->source(), condition.error().message);
    }
    if (reaction.after_us > kReactionUsMax) {
      keys_.Fail(table.get("after_ms")->source(),
                 MakeMessage("'after_ms' must be at most {0}", "“after_ms”应至多为 {0}",
                             ToMs(kReactionUsMax)));
    }
    ReadLevel(table, &reaction.input);
    if (world_.reactions.size() == kReactionMax) {
      keys_.Fail(table.source(),
                 MakeMessage("there are more than {0} [[world.react]]: join some of them",
                             "[[world.react]] 超过 {0} 个：应合并其中一些", kReactionMax));
      return;
    }
    places_.conditions.push_back(keys_.PlaceOfValue(table, "when"));
    world_.reactions.push_back(std::move(reaction));
  }

  /// The choice of an instant, which takes the place of `at_ms`.
  template <typename Event>
  void ReadBetween(const toml::table& table, Event* event) {
    const auto times = keys_.Times(table, "between_ms");
    if (!times) return;
    if (table.contains("at_ms")) {
      keys_.Fail(table.get("at_ms")->source(),
                 {"'at_ms' and 'between_ms' exclude each other: remove one of them",
                  "“at_ms”与“between_ms”不能同时使用：应去掉其一"});
    }
    std::tie(event->at_us, event->last_us) = *times;
  }

  void ReadMotor(const toml::table& table) {
    MotorSetup motor;
    const AxisUnit unit = ReadUnit(table);
    ReadKeysInUnit(table, MotorKeys(), unit, &motor);
    motor.axis = AxisOf(table);
    // What holds without a key does not depend on the unit.
    if (!table.contains("gain")) motor.gain = unit.FromPulses(motor.gain, AxisMeasure::kVelocity);
    if (!table.contains("index_period")) {
      motor.index_period = unit.FromPulses(motor.index_period, AxisMeasure::kPosition);
    }
    motor.drive = static_cast<motion::DriveKind>(keys_.Choice(table, "drive", kDriveNames, 0));
    for (const char* key : {"gain", "tau_ms", "friction"}) {
      Refuse(table, key, motor.drive == motion::DriveKind::kIdeal);
    }
    if (std::ranges::any_of(world_.motors,
                            [&](const MotorSetup& other) { return other.axis == motor.axis; })) {
      keys_.Fail(table.source(), MakeMessage("axis {0} is described twice; join the two tables",
                                             "轴 {0} 被描述两次；应合并为一项", motor.axis));
    }
    world_.motors.push_back(motor);
  }

  /// The unit of an axis whose keys say one; mistakes in the values are found when they are read.
  AxisUnit ReadUnit(const toml::table& table) {
    constexpr std::string_view kSeparators = "\",[] ";
    if (table.contains("pulses_per_unit") && !table.contains("unit")) {
      keys_.Fail(table.get("pulses_per_unit")->source(),
                 {"'pulses_per_unit' needs a 'unit', such as \"mm\": add it, or remove this",
                  "“pulses_per_unit”需要“unit”，如 \"mm\"：应加上，或去掉此键"});
    }
    if (!table.contains("unit")) return {};
    Need(table, "pulses_per_unit", {"how many pulses are one 'unit'", "一个“unit”的脉冲数"});
    const std::string name = table["unit"].value_or(std::string());
    const double pulses = table["pulses_per_unit"].value_or(0.0);
    const auto separates = [&](char c) {
      return static_cast<unsigned char>(c) < ' ' || kSeparators.find(c) != std::string_view::npos;
    };
    if (table["unit"].is_string() &&
        (name.empty() || name.size() > kUnitBytes || std::ranges::any_of(name, separates))) {
      keys_.Fail(table.get("unit")->source(),
                 MakeMessage("'unit' must be the name of a unit of at most {0} bytes, without "
                             "blanks, commas, quotation marks and brackets, such as \"mm\"",
                             "“unit”应为至多 {0} 字节的单位名称，不含空格、逗号、引号和方括号，如 "
                             "\"mm\"",
                             kUnitBytes));
    }
    return pulses > 0 ? AxisUnit{name, pulses} : AxisUnit();
  }

  /// ReadKeys() with the ranges of the rows in the unit of an axis.
  template <typename Structure>
  void ReadKeysInUnit(const toml::table& table, std::span<const Key<Structure>> rows,
                      const AxisUnit& unit, Structure* structure) {
    std::vector<Key<Structure>> in_unit(rows.begin(), rows.end());
    for (Key<Structure>& row : in_unit) row.about = InUnit(row.about, unit);
    ReadKeys(table, std::span<const Key<Structure>>(in_unit), keys_, structure);
  }

  void ReadSwitch(const toml::table& table) {
    SwitchSetup contact;
    contact.axis = AxisOf(table);
    ReadKeysInUnit(table, SwitchKeys(), UnitOf(world_, contact.axis), &contact);
    contact.type = InputType(table, "home");
    const int width = motion::DiWidth(contact.type);
    contact.index = static_cast<int>(keys_.Whole(table, "index", contact.axis, 1, width));
    if (contact.index > width) {
      Need(table, "index",
           {"there is no input with the number of the axis", "没有与轴号相同的输入"});
    }
    CheckPositions(table, contact.from, contact.to);
    if (std::ranges::any_of(world_.switches, [&](const SwitchSetup& other) {
          return other.type == contact.type && other.index == contact.index;
        })) {
      keys_.Fail(table.source(),
                 {"two switches are wired to this input: give one of them another 'index'",
                  "两个开关接到同一输入：应为其中一个指定其他“index”"});
    }
    world_.switches.push_back(contact);
  }

  void ReadMove(const toml::table& table) {
    SwitchMove move;
    move.number = SwitchOf(table, {"there is no switch to move: describe it under [[world.switch]]",
                                   "没有可移动的开关：应先在 [[world.switch]] 中描述"});
    AxisUnit unit;
    if (!world_.switches.empty()) {
      unit = UnitOf(world_, world_.switches[static_cast<size_t>(move.number - 1)].axis);
    }
    ReadKeysInUnit(table, MoveKeys(), unit, &move);
    CheckPositions(table, move.from, move.to);
    world_.moves.push_back(move);
  }

  void CheckPositions(const toml::table& table, double from, double to) {
    if (!table.contains("from") && !table.contains("to")) {
      keys_.Fail(table.source(), {"'from' or 'to' is missing: the position of the switch",
                                  "缺少“from”或“to”：开关的位置"});
    } else if (from > to) {
      keys_.Fail(table.source(),
                 {"'from' is greater than 'to': exchange them", "“from”大于“to”：应对调"});
    }
  }

  void ReadFault(const toml::table& table) {
    WorldFault fault;
    ReadKeys(table, FaultKeys(), keys_, &fault);
    if (!table.contains("kind")) {
      keys_.Fail(table.source(),
                 MakeMessage("'kind' is missing: one of {0}", "缺少“kind”：应为 {0} 之一",
                             fmt::to_string(fmt::join(kFaultNames, ", "))));
    }
    fault.kind = static_cast<FaultKind>(keys_.Choice(table, "kind", kFaultNames, 0));
    if (fault.kind == FaultKind::kCutSwitch) {
      fault.number =
          SwitchOf(table, {"there is no switch to cut: describe it under [[world.switch]]",
                           "没有可断开的开关：应先在 [[world.switch]] 中描述"});
    } else {
      fault.number = AxisOf(table);
    }
    const bool cut = fault.kind == FaultKind::kCutSwitch;
    Refuse(table, cut ? "axis" : "switch", true);
    Refuse(table, "pulses", fault.kind != FaultKind::kNoise);
    Refuse(table, "velocity", fault.kind != FaultKind::kSlip);
    if (fault.kind == FaultKind::kNoise) {
      int64_t pulses = 0;
      ReadValue(table, RowOf(FaultKeys(), "pulses"), keys_, pulses);
      fault.amount = static_cast<double>(pulses);
      Need(table, "pulses", {"the largest error of a reading", "读数的最大误差"});
    } else if (fault.kind == FaultKind::kSlip) {
      ReadValue(table, InUnit(RowOf(FaultKeys(), "velocity"), UnitOf(world_, fault.number)), keys_,
                fault.amount);
      Need(table, "velocity", {"the velocity of the slip", "滑移速度"});
    }
    ReadBetween(table, &fault);
    if (fault.until_us && *fault.until_us <= fault.last_us.value_or(fault.at_us)) {
      keys_.Fail(table.source(),
                 fault.last_us
                     ? Message{"'until_ms' must be later than the end of 'between_ms'",
                               "“until_ms”应晚于“between_ms”的末端"}
                     : Message{"'until_ms' must be later than 'at_ms'", "“until_ms”应晚于“at_ms”"});
    }
    CheckFault(table, fault);
    places_.faults.push_back(keys_.PlaceOfValue(table, "between_ms"));
    world_.faults.push_back(fault);
  }

  /// Faults of the same kind must not overlap: the end of one would also end the other.
  void CheckFault(const toml::table& table, const WorldFault& fault) {
    for (const WorldFault& other : world_.faults) {
      const bool same = other.kind == fault.kind && other.number == fault.number;
      const bool before = fault.until_us && *fault.until_us <= other.at_us;
      const bool after = other.until_us && *other.until_us <= fault.at_us;
      if (!same || before || after) continue;
      keys_.Fail(table.source(),
                 {"this fault overlaps another one of its kind: end one before the other begins",
                  "该故障与同类故障在时间上重叠：应使其先后发生"});
    }
  }

  void ReadHand(const toml::table& table) {
    HandTurn turn;
    ReadKeys(table, HandKeys(), keys_, &turn);
    if (!table.contains("encoder")) {
      turn.number = AxisOf(table);
    } else {
      Refuse(table, "axis", true);
      turn.number = AuxiliaryOf(table);
    }
    Need(table, "pulses", {"the distance, negative for backwards", "转动的脉冲数，反向为负"});
    Need(table, "until_ms", {"the time at which it ends", "转到的时刻"});
    CheckHand(table, turn);
    world_.hands.push_back(turn);
  }

  void CheckHand(const toml::table& table, const HandTurn& turn) {
    if (!table.contains("until_ms")) return;
    const int64_t length_us = turn.until_us - turn.at_us;
    if (length_us < kHandTurnUsMin) {
      keys_.Fail(table.source(),
                 MakeMessage("'until_ms' must be at least {0} ms after 'at_ms'",
                             "“until_ms”应比“at_ms”晚至少 {0} ms", kHandTurnUsMin / 1000));
    } else if (std::fabs(turn.pulses) > kWorldVelocityMax * static_cast<double>(length_us) / 1000) {
      keys_.Fail(table.source(),
                 MakeMessage("that is faster than {0} pulse/ms: give it more time",
                             "速度超过 {0} pulse/ms：应延长时间", kWorldVelocityMax));
    }
    for (const HandTurn& other : world_.hands) {
      const bool apart = turn.until_us <= other.at_us || other.until_us <= turn.at_us;
      if (other.number != turn.number || apart) continue;
      keys_.Fail(table.source(), {"this turn overlaps another one: end one before the other begins",
                                  "该转动与另一次转动在时间上重叠：应使其先后发生"});
    }
  }

  int AuxiliaryOf(const toml::table& table) {
    const KeyDescription& row = RowOf(HandKeys(), "encoder");
    int encoder = static_cast<int>(row.type.smallest);
    if (axis_count_ >= encoder) {
      keys_.Fail(table.get("encoder")->source(),
                 MakeMessage("a card of {0} axes has no auxiliary encoders: turn an 'axis'",
                             "{0} 轴控制卡没有辅助编码器：应指定“axis”", axis_count_));
    }
    ReadValue(table, row, keys_, encoder);
    return encoder;
  }

  /// An input to which a switch is connected follows the switch only.
  void CheckInputs(const toml::table& table) {
    const auto driven = [this](const InputEvent& event) {
      return std::ranges::any_of(world_.switches, [&](const SwitchSetup& contact) {
        return contact.type == event.type && (event.index == 0 || event.index == contact.index);
      });
    };
    if (std::ranges::any_of(world_.inputs, driven)) {
      keys_.Fail(table.source(), DescribeTwoDrivers("input"));
    }
    for (size_t i = 0; i < world_.reactions.size(); ++i) {
      if (!driven(world_.reactions[i].input)) continue;
      keys_.Fail(places_.conditions[i], DescribeTwoDrivers("react"));
    }
  }

  static Message DescribeTwoDrivers(std::string_view key) {
    return MakeMessage(
        "a [[world.{0}]] drives an input that a [[world.switch]] is wired to: remove one of them, "
        "or give the input an 'index'",
        "[[world.{0}]] 与 [[world.switch]] 驱动同一输入：应去掉其一，或为输入指定“index”", key);
  }

  void ReadVoltage(const toml::table& table) {
    VoltageEvent event;
    ReadKeys(table, VoltageKeys(), keys_, &event);
    Need(table, "volts", {"the voltage at the input", "输入端的电压"});
    world_.voltages.push_back(event);
  }

  void ReadModule(const toml::table& table) {
    ModuleEvent event;
    ReadKeys(table, ModuleKeys(), keys_, &event);
    if (table.contains("inputs")) {
      int inputs = 0;
      ReadValue(table, RowOf(ModuleKeys(), "inputs"), keys_, inputs);
      event.inputs = static_cast<uint16_t>(inputs);
    }
    if (const toml::node* node = table.get("volts")) ReadModuleVolts(*node, event);
    world_.modules.push_back(std::move(event));
  }

  void ReadModuleVolts(const toml::node& node, ModuleEvent& event) {
    const toml::array* list = node.as_array();
    bool good = list != nullptr && list->size() <= motion::kModuleChannels;
    for (size_t i = 0; good && i < list->size(); ++i) {
      const auto volts = (*list)[i].value<double>();
      good = volts && std::fabs(*volts) <= motion::kModuleFullVolts;
      if (good) event.volts.push_back(*volts);
    }
    if (good) return;
    keys_.Fail(node.source(),
               MakeMessage("'volts' must be a list of at most {0} voltages from -{1} to {1}",
                           "“volts”应为至多 {0} 个电压的列表，取值 -{1} 至 {1}",
                           motion::kModuleChannels, motion::kModuleFullVolts));
  }

  /// Reports a key that has no effect for this kind of object.
  void Refuse(const toml::table& table, std::string_view key, bool meaningless) {
    if (!meaningless || !table.contains(key)) return;
    keys_.Fail(table.get(key)->source(),
               MakeMessage("'{0}' has no effect here: remove it", "“{0}”在此无意义：应去掉", key));
  }

  int AxisOf(const toml::table& table) {
    const int64_t axis = keys_.Whole(table, "axis", 1, 1, axis_count_);
    Need(table, "axis", {"the number of the axis, from 1", "轴号，从 1 开始"});
    return static_cast<int>(axis);
  }

  int SwitchOf(const toml::table& table, const Message& none) {
    Need(table, "switch",
         {"the number of the [[world.switch]], from 1", "[[world.switch]] 的序号，从 1 开始"});
    if (world_.switches.empty()) {
      keys_.Fail(table.source(), none);
      return 1;
    }
    const auto count = static_cast<int64_t>(world_.switches.size());
    return static_cast<int>(keys_.Whole(table, "switch", 1, 1, count));
  }

  motion::DiType InputType(const toml::table& table, std::string_view absent) {
    std::string type(absent);
    keys_.Text(table, "type", type);
    if (const auto word = FindInputWord(type)) return *word;
    keys_.Fail(table.source(),
               MakeMessage("no inputs are named '{0}': expected limit_positive, limit_negative, "
                           "alarm, home, gpi, arrive or mpg",
                           "没有名为“{0}”的输入：应为 limit_positive、limit_negative、alarm、home、"
                           "gpi、arrive 或 mpg",
                           type));
    return motion::DiType::kGpi;
  }

  void Need(const toml::table& table, std::string_view key, const Message& what) {
    if (table.contains(key)) return;
    keys_.Fail(table.source(), {fmt::format("'{}' is missing: {}", key, what.en),
                                fmt::format("缺少“{}”：{}", key, what.zh)});
  }

  const int axis_count_;
  TomlKeys& keys_;
  WorldPlaces& places_;
  World world_;
};

// --- Writing -----------------------------------------------------------------------------------

SpecialText LevelText(const InputEvent& event, std::string_view key) {
  if (key == "type") return TomlString(InputWordName(event.type));
  if (key == "index" && event.index != 0) return std::to_string(event.index);
  if (key == "value") return event.any_level ? TomlString(kAnyLevel) : std::to_string(event.value);
  return std::nullopt;
}

/// The keys of an instant that is open; nothing for any other key.
template <typename Event>
SpecialText FormatBetween(const Event& event, std::string_view key) {
  if (!event.last_us) return std::nullopt;
  if (key == "at_ms") return "";
  if (key != "between_ms") return std::nullopt;
  return fmt::format("[{}, {}]", FormatMs(event.at_us), FormatMs(*event.last_us));
}

std::string FormatInput(const InputEvent& event) {
  return AsTable("[[world.input]]", WriteKeys(event, InputKeys(), [&](std::string_view key) {
                   const SpecialText level = LevelText(event, key);
                   return level ? level : FormatBetween(event, key);
                 }));
}

std::string FormatReaction(const InputReaction& reaction) {
  return AsTable("[[world.react]]", WriteKeys(reaction, ReactionKeys(), [&](std::string_view key) {
                   return LevelText(reaction.input, key);
                 }));
}

std::string FormatMotor(const MotorSetup& motor) {
  const bool ideal = motor.drive == motion::DriveKind::kIdeal;
  return AsTable("[[world.axis]]", WriteKeys(motor, MotorKeys(), [&](std::string_view key) {
                   if (key == "axis") return SpecialText(std::to_string(motor.axis));
                   if (key == "drive") {
                     return SpecialText(TomlString(kDriveNames[static_cast<size_t>(motor.drive)]));
                   }
                   if (ideal && (key == "gain" || key == "tau_ms" || key == "friction")) {
                     return SpecialText("");
                   }
                   return SpecialText();
                 }));
}

std::string FormatSwitch(const SwitchSetup& contact) {
  return AsTable("[[world.switch]]", WriteKeys(contact, SwitchKeys(), [&](std::string_view key) {
                   if (key == "axis") return SpecialText(std::to_string(contact.axis));
                   if (key == "type") return SpecialText(TomlString(InputWordName(contact.type)));
                   if (key == "index") return SpecialText(std::to_string(contact.index));
                   return SpecialText();
                 }));
}

std::string FormatMove(const SwitchMove& move) {
  return AsTable("[[world.move]]", WriteKeys(move, MoveKeys(), [&](std::string_view key) {
                   return key == "switch" ? SpecialText(std::to_string(move.number))
                                          : SpecialText();
                 }));
}

std::string FormatFault(const WorldFault& fault) {
  const std::string_view number = fault.kind == FaultKind::kCutSwitch ? "switch" : "axis";
  const std::string_view amount = fault.kind == FaultKind::kNoise  ? "pulses"
                                  : fault.kind == FaultKind::kSlip ? "velocity"
                                                                   : "";
  return AsTable("[[world.fault]]", WriteKeys(fault, FaultKeys(), [&](std::string_view key) {
                   if (key == "kind") {
                     return SpecialText(TomlString(kFaultNames[static_cast<size_t>(fault.kind)]));
                   }
                   if (key == number) return SpecialText(std::to_string(fault.number));
                   if (key == amount) return SpecialText(fmt::format("{}", fault.amount));
                   return FormatBetween(fault, key);
                 }));
}

std::string FormatHand(const HandTurn& turn, int axis_count) {
  const std::string_view number = turn.number > axis_count ? "encoder" : "axis";
  return AsTable("[[world.hand]]", WriteKeys(turn, HandKeys(), [&](std::string_view key) {
                   return key == number ? SpecialText(std::to_string(turn.number)) : SpecialText();
                 }));
}

std::string FormatModule(const ModuleEvent& event) {
  return AsTable("[[world.module]]", WriteKeys(event, ModuleKeys(), [&](std::string_view key) {
                   if (key == "inputs" && event.inputs) {
                     return SpecialText(std::to_string(*event.inputs));
                   }
                   if (key == "volts" && !event.volts.empty()) {
                     return SpecialText(fmt::format("[{}]", fmt::join(event.volts, ", ")));
                   }
                   return SpecialText();
                 }));
}

}  // namespace

World ReadWorld(const toml::table& table, int axis_count, TomlKeys& keys, WorldPlaces* places) {
  return WorldReader(axis_count, keys, places).Read(table);
}

std::string FormatWorld(const World& world, int axis_count) {
  std::string text;
  for (const InputEvent& event : world.inputs) text += FormatInput(event);
  for (const InputReaction& reaction : world.reactions) text += FormatReaction(reaction);
  for (const MotorSetup& motor : world.motors) text += FormatMotor(motor);
  for (const SwitchSetup& contact : world.switches) text += FormatSwitch(contact);
  for (const SwitchMove& move : world.moves) text += FormatMove(move);
  for (const WorldFault& fault : world.faults) text += FormatFault(fault);
  for (const HandTurn& turn : world.hands) text += FormatHand(turn, axis_count);
  for (const VoltageEvent& event : world.voltages) {
    text += AsTable("[[world.analog]]", WriteKeys(event, VoltageKeys()));
  }
  for (const ModuleEvent& event : world.modules) text += FormatModule(event);
  return text;
}

}  // namespace oncard::runtime
