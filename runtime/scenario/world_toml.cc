#include "runtime/scenario/world_toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "base/milliseconds.h"
#include "motion/io/analog.h"
#include "motion/io/extension.h"
#include "runtime/observe/quantity.h"

namespace oncard::runtime {
namespace {

using Keys = std::span<const std::string_view>;

constexpr std::array<std::string_view, 7> kWorldKeys = {"input", "axis",   "switch", "fault",
                                                        "hand",  "analog", "module"};
constexpr std::array<std::string_view, 4> kInputKeys = {"type", "index", "value", "at_ms"};
constexpr std::array<std::string_view, 8> kMachineKeys = {
    "axis", "drive", "gain", "tau_ms", "friction", "position", "index_offset", "index_period"};
constexpr std::array<std::string_view, 6> kSwitchKeys = {"axis", "type", "index",
                                                         "from", "to",   "active_low"};
constexpr std::array<std::string_view, 7> kFaultKeys = {"kind",     "axis",   "switch",  "at_ms",
                                                        "until_ms", "pulses", "velocity"};
constexpr std::array<std::string_view, 5> kHandKeys = {"axis", "encoder", "pulses", "at_ms",
                                                       "until_ms"};
constexpr std::array<std::string_view, 3> kVoltageKeys = {"channel", "volts", "at_ms"};
constexpr std::array<std::string_view, 4> kModuleKeys = {"module", "inputs", "volts", "at_ms"};

/// Limit of positions in the world, pulses: the range of an axis.
constexpr double kPositionMax = 2147483648.0;
constexpr double kVelocityMax = 32767;
constexpr double kTauMsMax = 10'000;
constexpr double kNoiseMax = 1'000'000;
constexpr double kSlipMax = 1000;

template <typename Event>
void SortByTime(std::vector<Event>& events) {
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.at_us < b.at_us; });
}

class WorldReader {
 public:
  WorldReader(int axis_count, TomlKeys& keys) : axis_count_(axis_count), keys_(keys) {}

  World Read(const toml::table& table) {
    keys_.CheckKeys(table, kWorldKeys);
    for (const toml::table* input : keys_.Tables(table, "input")) ReadInput(*input);
    for (const toml::table* machine : keys_.Tables(table, "axis")) ReadMachine(*machine);
    for (const toml::table* contact : keys_.Tables(table, "switch")) ReadSwitch(*contact);
    for (const toml::table* fault : keys_.Tables(table, "fault")) ReadFault(*fault);
    for (const toml::table* hand : keys_.Tables(table, "hand")) ReadHand(*hand);
    for (const toml::table* voltage : keys_.Tables(table, "analog")) ReadVoltage(*voltage);
    for (const toml::table* module : keys_.Tables(table, "module")) ReadModule(*module);
    CheckInputs(table);
    SortByTime(world_.inputs);
    SortByTime(world_.voltages);
    SortByTime(world_.modules);
    return std::move(world_);
  }

 private:
  void ReadInput(const toml::table& table) {
    keys_.CheckKeys(table, kInputKeys);
    InputEvent event;
    event.type = InputType(table, "gpi");
    const int width = motion::DiWidth(event.type);
    event.index = static_cast<int>(keys_.Whole(table, "index", 0, 1, width));
    const int64_t highest = event.index == 0 ? (int64_t{1} << width) - 1 : 1;
    event.value = static_cast<uint32_t>(keys_.Whole(table, "value", -1, 0, highest));
    if (!table.contains("value")) {
      keys_.Fail(table.source(), {"'value' is missing: the level of the pin, 0 or 1",
                                  "缺少“value”：管脚电平，0 或 1"});
    }
    event.at_us = keys_.Time(table, "at_ms");
    world_.inputs.push_back(event);
  }

  void ReadMachine(const toml::table& table) {
    keys_.CheckKeys(table, kMachineKeys);
    MachineSetup machine;
    machine.axis = AxisOf(table);
    machine.drive = static_cast<motion::DriveKind>(keys_.Choice(table, "drive", kDriveNames, 0));
    for (const char* key : {"gain", "tau_ms", "friction"}) {
      Refuse(table, key, machine.drive == motion::DriveKind::kIdeal);
    }
    machine.gain = keys_.Number(table, "gain", machine.gain, 0, kVelocityMax);
    machine.tau_ms = keys_.Number(table, "tau_ms", machine.tau_ms, 0, kTauMsMax);
    machine.friction = keys_.Number(table, "friction", machine.friction, 0, kVelocityMax);
    machine.position = Position(table, "position", 0);
    machine.index_offset = Position(table, "index_offset", 0);
    machine.index_period =
        keys_.Number(table, "index_period", machine.index_period, 0, kPositionMax);
    if (std::ranges::any_of(world_.machines, [&](const MachineSetup& other) {
          return other.axis == machine.axis;
        })) {
      keys_.Fail(table.source(), MakeMessage("axis {0} is described twice; join the two tables",
                                             "轴 {0} 被描述两次；应合并为一项", machine.axis));
    }
    world_.machines.push_back(machine);
  }

  void ReadSwitch(const toml::table& table) {
    keys_.CheckKeys(table, kSwitchKeys);
    SwitchSetup contact;
    contact.axis = AxisOf(table);
    contact.type = InputType(table, "home");
    const int width = motion::DiWidth(contact.type);
    contact.index = static_cast<int>(keys_.Whole(table, "index", contact.axis, 1, width));
    if (contact.index > width) {
      Need(table, "index",
           {"there is no input with the number of the axis", "没有与轴号相同的输入"});
    }
    contact.from = Position(table, "from", contact.from);
    contact.to = Position(table, "to", contact.to);
    contact.active_low = keys_.Flag(table, "active_low", false);
    if (!table.contains("from") && !table.contains("to")) {
      keys_.Fail(table.source(), {"'from' or 'to' is missing: the position of the switch in pulses",
                                  "缺少“from”或“to”：开关的位置，单位脉冲"});
    } else if (contact.from > contact.to) {
      keys_.Fail(table.source(),
                 {"'from' is greater than 'to': exchange them", "“from”大于“to”：应对调"});
    }
    if (std::ranges::any_of(world_.switches, [&](const SwitchSetup& other) {
          return other.type == contact.type && other.index == contact.index;
        })) {
      keys_.Fail(table.source(),
                 {"two switches are wired to this input: give one of them another 'index'",
                  "两个开关接到同一输入：应为其中一个指定其他“index”"});
    }
    world_.switches.push_back(contact);
  }

  void ReadFault(const toml::table& table) {
    keys_.CheckKeys(table, kFaultKeys);
    WorldFault fault;
    if (!table.contains("kind")) {
      keys_.Fail(table.source(),
                 MakeMessage("'kind' is missing: one of {0}", "缺少“kind”：应为 {0} 之一",
                             fmt::to_string(fmt::join(kFaultNames, ", "))));
    }
    fault.kind = static_cast<FaultKind>(keys_.Choice(table, "kind", kFaultNames, 0));
    if (fault.kind == FaultKind::kCutSwitch) {
      fault.number = SwitchOf(table);
    } else {
      fault.number = AxisOf(table);
    }
    const bool cut = fault.kind == FaultKind::kCutSwitch;
    Refuse(table, cut ? "axis" : "switch", true);
    Refuse(table, "pulses", fault.kind != FaultKind::kNoise);
    Refuse(table, "velocity", fault.kind != FaultKind::kSlip);
    if (fault.kind == FaultKind::kNoise) {
      fault.amount =
          static_cast<double>(keys_.Whole(table, "pulses", 0, 1, static_cast<int64_t>(kNoiseMax)));
      Need(table, "pulses", {"the largest error of a reading", "读数的最大误差"});
    } else if (fault.kind == FaultKind::kSlip) {
      fault.amount = keys_.Number(table, "velocity", 0, -kSlipMax, kSlipMax);
      Need(table, "velocity", {"the velocity of the slip, in pulse/ms", "滑移速度，单位 pulse/ms"});
    }
    fault.at_us = keys_.Time(table, "at_ms");
    if (table.contains("until_ms")) {
      fault.until_us = keys_.Time(table, "until_ms");
      if (*fault.until_us <= fault.at_us) {
        keys_.Fail(table.source(),
                   {"'until_ms' must be later than 'at_ms'", "“until_ms”应晚于“at_ms”"});
      }
    }
    CheckFault(table, fault);
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
    keys_.CheckKeys(table, kHandKeys);
    HandTurn turn;
    if (!table.contains("encoder")) {
      turn.number = AxisOf(table);
    } else {
      Refuse(table, "axis", true);
      turn.number = AuxiliaryOf(table);
    }
    turn.pulses = Position(table, "pulses", 0);
    Need(table, "pulses", {"the distance, negative for backwards", "转动的脉冲数，反向为负"});
    turn.at_us = keys_.Time(table, "at_ms");
    turn.until_us = keys_.Time(table, "until_ms");
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
    } else if (std::fabs(turn.pulses) > kVelocityMax * static_cast<double>(length_us) / 1000) {
      keys_.Fail(table.source(), MakeMessage("that is faster than {0} pulse/ms: give it more time",
                                             "速度超过 {0} pulse/ms：应延长时间", kVelocityMax));
    }
    for (const HandTurn& other : world_.hands) {
      const bool apart = turn.until_us <= other.at_us || other.until_us <= turn.at_us;
      if (other.number != turn.number || apart) continue;
      keys_.Fail(table.source(), {"this turn overlaps another one: end one before the other begins",
                                  "该转动与另一次转动在时间上重叠：应使其先后发生"});
    }
  }

  int AuxiliaryOf(const toml::table& table) {
    constexpr int kFirst = static_cast<int>(motion::kAuxiliaryFirst) + 1;
    constexpr int kLast = kFirst + static_cast<int>(motion::kAuxiliaryCount) - 1;
    if (axis_count_ >= kFirst) {
      keys_.Fail(table.get("encoder")->source(),
                 MakeMessage("a card of {0} axes has no auxiliary encoders: turn an 'axis'",
                             "{0} 轴控制卡没有辅助编码器：应指定“axis”", axis_count_));
    }
    return static_cast<int>(keys_.Whole(table, "encoder", kFirst, kFirst, kLast));
  }

  /// An input to which a switch is connected follows the switch only.
  void CheckInputs(const toml::table& table) {
    for (const InputEvent& event : world_.inputs) {
      const bool driven = std::ranges::any_of(world_.switches, [&](const SwitchSetup& contact) {
        return contact.type == event.type && (event.index == 0 || event.index == contact.index);
      });
      if (!driven) continue;
      keys_.Fail(
          table.source(),
          {"a [[world.input]] drives an input that a [[world.switch]] is wired to: remove "
           "one of them, or give the input an 'index'",
           "[[world.input]] 与 [[world.switch]] 驱动同一输入：应去掉其一，或为输入指定“index”"});
      return;
    }
  }

  void ReadVoltage(const toml::table& table) {
    keys_.CheckKeys(table, kVoltageKeys);
    VoltageEvent event;
    event.channel = static_cast<int>(
        keys_.Whole(table, "channel", 1, 1, static_cast<int64_t>(motion::kAdcCount)));
    event.volts = keys_.Number(table, "volts", 0, -motion::kAdcFullVolts, motion::kAdcFullVolts);
    Need(table, "volts", {"the voltage at the input", "输入端的电压"});
    event.at_us = keys_.Time(table, "at_ms");
    world_.voltages.push_back(event);
  }

  void ReadModule(const toml::table& table) {
    keys_.CheckKeys(table, kModuleKeys);
    ModuleEvent event;
    event.module = static_cast<int>(
        keys_.Whole(table, "module", 0, 0, static_cast<int64_t>(motion::kModuleCount) - 1));
    if (table.contains("inputs")) {
      event.inputs = static_cast<uint16_t>(keys_.Whole(table, "inputs", 0, 0, 0xffff));
    }
    if (const toml::node* node = table.get("volts")) ReadModuleVolts(*node, event);
    event.at_us = keys_.Time(table, "at_ms");
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

  int SwitchOf(const toml::table& table) {
    Need(table, "switch",
         {"the number of the [[world.switch]], from 1", "[[world.switch]] 的序号，从 1 开始"});
    if (world_.switches.empty()) {
      keys_.Fail(table.source(), {"there is no switch to cut: describe it under [[world.switch]]",
                                  "没有可断开的开关：应先在 [[world.switch]] 中描述"});
      return 1;
    }
    const auto count = static_cast<int64_t>(world_.switches.size());
    return static_cast<int>(keys_.Whole(table, "switch", 1, 1, count));
  }

  double Position(const toml::table& table, std::string_view key, double absent) {
    return keys_.Number(table, key, absent, -kPositionMax, kPositionMax);
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
  World world_;
};

// --- Writing -----------------------------------------------------------------------------------

std::string FormatMachine(const MachineSetup& machine) {
  std::string text = fmt::format("\n[[world.axis]]\naxis = {}\ndrive = \"{}\"\n", machine.axis,
                                 kDriveNames[static_cast<size_t>(machine.drive)]);
  if (machine.drive == motion::DriveKind::kVelocity) {
    text += fmt::format("gain = {}\ntau_ms = {}\nfriction = {}\n", machine.gain, machine.tau_ms,
                        machine.friction);
  }
  return text + fmt::format("position = {}\nindex_offset = {}\nindex_period = {}\n",
                            machine.position, machine.index_offset, machine.index_period);
}

std::string FormatSwitch(const SwitchSetup& contact) {
  std::string text = fmt::format("\n[[world.switch]]\naxis = {}\ntype = \"{}\"\nindex = {}\n",
                                 contact.axis, InputWordName(contact.type), contact.index);
  if (std::isfinite(contact.from)) text += fmt::format("from = {}\n", contact.from);
  if (std::isfinite(contact.to)) text += fmt::format("to = {}\n", contact.to);
  if (contact.active_low) text += "active_low = true\n";
  return text;
}

std::string FormatFault(const WorldFault& fault) {
  const bool cut = fault.kind == FaultKind::kCutSwitch;
  std::string text = fmt::format("\n[[world.fault]]\nkind = \"{}\"\n{} = {}\nat_ms = {}\n",
                                 kFaultNames[static_cast<size_t>(fault.kind)],
                                 cut ? "switch" : "axis", fault.number, ToMs(fault.at_us));
  if (fault.until_us) text += fmt::format("until_ms = {}\n", ToMs(*fault.until_us));
  if (fault.kind == FaultKind::kNoise) text += fmt::format("pulses = {}\n", fault.amount);
  if (fault.kind == FaultKind::kSlip) text += fmt::format("velocity = {}\n", fault.amount);
  return text;
}

std::string FormatHand(const HandTurn& turn, int axis_count) {
  return fmt::format("\n[[world.hand]]\n{} = {}\npulses = {}\nat_ms = {}\nuntil_ms = {}\n",
                     turn.number > axis_count ? "encoder" : "axis", turn.number, turn.pulses,
                     ToMs(turn.at_us), ToMs(turn.until_us));
}

}  // namespace

World ReadWorld(const toml::table& table, int axis_count, TomlKeys& keys) {
  return WorldReader(axis_count, keys).Read(table);
}

std::string FormatWorld(const World& world, int axis_count) {
  std::string text;
  for (const InputEvent& event : world.inputs) {
    text += fmt::format("\n[[world.input]]\ntype = \"{}\"\n", InputWordName(event.type));
    if (event.index != 0) text += fmt::format("index = {}\n", event.index);
    text += fmt::format("value = {}\nat_ms = {}\n", event.value, ToMs(event.at_us));
  }
  for (const MachineSetup& machine : world.machines) text += FormatMachine(machine);
  for (const SwitchSetup& contact : world.switches) text += FormatSwitch(contact);
  for (const WorldFault& fault : world.faults) text += FormatFault(fault);
  for (const HandTurn& turn : world.hands) text += FormatHand(turn, axis_count);
  for (const VoltageEvent& event : world.voltages) {
    text += fmt::format("\n[[world.analog]]\nchannel = {}\nvolts = {}\nat_ms = {}\n", event.channel,
                        event.volts, ToMs(event.at_us));
  }
  for (const ModuleEvent& event : world.modules) {
    text += fmt::format("\n[[world.module]]\nmodule = {}\n", event.module);
    if (event.inputs) text += fmt::format("inputs = {}\n", *event.inputs);
    if (!event.volts.empty()) text += fmt::format("volts = [{}]\n", fmt::join(event.volts, ", "));
    text += fmt::format("at_ms = {}\n", ToMs(event.at_us));
  }
  return text;
}

}  // namespace oncard::runtime
