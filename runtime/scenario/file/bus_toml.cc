#include "runtime/scenario/file/bus_toml.h"

#include <algorithm>
#include <cmath>

#include "runtime/scenario/file/key_table.h"
#include "runtime/scenario/file/keyed_toml.h"

namespace oncard::runtime {
namespace {

using motion::bus::SlaveKind;

class BusReader {
 public:
  BusReader(int axis_count, TomlKeys& keys) : axis_count_(axis_count), keys_(keys) {}

  BusSetup Read(const toml::table& table) {
    ReadKeys(table, BusKeys(), keys_, &bus_);
    bus_.slaves = ReadSlaves(table, "ethercat.slave", BusSlaveKeys());
    bus_.configured = ReadSlaves(table, "ethercat.configured", ConfiguredSlaveKeys());
    for (const toml::table* input : keys_.Tables(table, "ethercat.input")) ReadInput(*input);
    std::stable_sort(
        bus_.inputs.begin(), bus_.inputs.end(),
        [](const BusInputEvent& a, const BusInputEvent& b) { return a.at_us < b.at_us; });
    return std::move(bus_);
  }

 private:
  std::vector<BusSlaveSetup> ReadSlaves(const toml::table& table, std::string_view path,
                                        std::span<const Key<BusSlaveSetup>> rows) {
    std::vector<BusSlaveSetup> slaves;
    motion::bus::Slaves described;
    for (const toml::table* each : keys_.Tables(table, path)) {
      BusSlaveSetup slave = ReadSlave(*each, rows, slaves);
      described.push_back(SlaveOf(slave));
      slaves.push_back(std::move(slave));
      if (slaves.size() > motion::bus::kSlaveMax) {
        keys_.Fail(each->source(), MakeMessage("a bus has at most {0} slaves",
                                               "总线至多有 {0} 个从站", motion::bus::kSlaveMax));
        break;
      }
      if (ImageSize(described) > motion::bus::kImageMax) {
        keys_.Fail(each->source(),
                   MakeMessage("the process data of all slaves take more than {0} bytes",
                               "所有从站的过程数据超过 {0} 字节", motion::bus::kImageMax));
        break;
      }
    }
    return slaves;
  }

  BusSlaveSetup ReadSlave(const toml::table& table, std::span<const Key<BusSlaveSetup>> rows,
                          const std::vector<BusSlaveSetup>& before) {
    BusSlaveSetup slave;
    ReadKeys(table, rows, keys_, &slave);
    slave.kind =
        static_cast<SlaveKind>(keys_.Choice(table, "kind", motion::bus::kSlaveKindNames, 0));
    for (const char* key : {"outputs", "inputs"}) CheckEntries(table, key, slave);
    if (slave.kind != SlaveKind::kDrive) {
      if (table.contains("axis")) {
        keys_.Fail(table.get("axis")->source(),
                   {"only a drive has an 'axis': remove it", "只有驱动器才有“axis”：应去掉"});
      }
      return slave;
    }
    const auto drives = std::ranges::count(before, SlaveKind::kDrive, &BusSlaveSetup::kind);
    slave.axis = static_cast<int>(keys_.Whole(table, "axis", drives + 1, 1, axis_count_));
    const bool taken = std::ranges::any_of(before, [&](const BusSlaveSetup& other) {
      return other.kind == SlaveKind::kDrive && other.axis == slave.axis;
    });
    if (taken || slave.axis > axis_count_) {
      keys_.Fail(table.source(),
                 MakeMessage("axis {0} is not free for this drive: give it another 'axis'",
                             "轴 {0} 不能用于该驱动器：应指定其他“axis”", slave.axis));
    }
    return slave;
  }

  void CheckEntries(const toml::table& table, const char* key, const BusSlaveSetup& slave) {
    const bool outputs = std::string_view(key) == "outputs";
    const std::vector<std::string>& texts = outputs ? slave.outputs : slave.inputs;
    if (texts.size() == 1 && texts.front() == kNoEntries) return;
    for (const std::string& text : texts) {
      const auto entry = ParsePdoEntry(text, slave.kind);
      if (!entry.ok()) {
        keys_.Fail(table.get(key)->source(), entry.error().message);
      } else if (outputs && slave.kind == SlaveKind::kDrive && !IsWritten(entry.value())) {
        keys_.Fail(table.get(key)->source(),
                   MakeMessage("object '{0}' can only be read: it belongs to 'inputs'",
                               "对象“{0}”只能读取：应列入“inputs”", text));
      }
    }
  }

  static bool IsWritten(const motion::bus::PdoEntry& entry) {
    const auto id = motion::bus::FindObject(entry.index, entry.subindex);
    return !id || EntryOf(*id).access == motion::bus::ObjectAccess::kReadWrite;
  }

  void ReadInput(const toml::table& table) {
    BusInputEvent event;
    ReadKeys(table, BusInputKeys(), keys_, &event);
    for (const char* key : {"slave", "object", "value"}) {
      if (table.contains(key)) continue;
      keys_.Fail(table.source(), MakeMessage("'{0}' is missing", "缺少“{0}”", key));
      return;
    }
    const auto number = static_cast<size_t>(event.slave);
    if (number >= bus_.slaves.size()) {
      keys_.Fail(table.get("slave")->source(),
                 MakeMessage("there are {0} slaves, counted from 0",
                             "共有 {0} 个从站，从 0 开始编号", bus_.slaves.size()));
      return;
    }
    const auto terminal = FindTerminal(SlaveOf(bus_.slaves[number]), event.object);
    if (!terminal) {
      keys_.Fail(table.get("object")->source(),
                 MakeMessage("slave {0} has no input '{1}'", "从站 {0} 没有输入“{1}”", number,
                             event.object));
    } else if (event.value != std::floor(event.value) ||
               (terminal->probe && event.value != 0 && event.value != 1)) {
      keys_.Fail(table.get("value")->source(),
                 {"'value' must be a whole number, and 0 or 1 for a probe",
                  "“value”应为整数，探针为 0 或 1"});
    }
    bus_.inputs.push_back(std::move(event));
  }

  const int axis_count_;
  TomlKeys& keys_;
  BusSetup bus_;
};

std::string FormatSlave(std::string_view header, const BusSlaveSetup& slave,
                        std::span<const Key<BusSlaveSetup>> rows) {
  return AsTable(header, WriteKeys(slave, rows, [&](std::string_view key) {
                   if (key == "kind") {
                     const auto kind = static_cast<size_t>(slave.kind);
                     return SpecialText(TomlString(motion::bus::kSlaveKindNames[kind]));
                   }
                   if (key == "axis" && slave.kind == SlaveKind::kDrive) {
                     return SpecialText(std::to_string(slave.axis));
                   }
                   return SpecialText();
                 }));
}

}  // namespace

BusSetup ReadBus(const toml::table& table, int axis_count, TomlKeys& keys) {
  return BusReader(axis_count, keys).Read(table);
}

std::string FormatBus(const BusSetup& bus) {
  std::string text;
  for (const BusSlaveSetup& slave : bus.slaves) {
    text += FormatSlave("[[ethercat.slave]]", slave, BusSlaveKeys());
  }
  for (const BusSlaveSetup& slave : bus.configured) {
    text += FormatSlave("[[ethercat.configured]]", slave, ConfiguredSlaveKeys());
  }
  for (const BusInputEvent& event : bus.inputs) {
    text += AsTable("[[ethercat.input]]", WriteKeys(event, BusInputKeys()));
  }
  return text;
}

}  // namespace oncard::runtime
