#include "runtime/scenario/world/bus_setup.h"

#include <fmt/format.h>

#include <charconv>

#include "motion/bus/objects.h"

namespace oncard::runtime {
namespace {

using motion::bus::ObjectEntry;
using motion::bus::ObjectId;
using motion::bus::PdoEntry;
using motion::bus::Slave;
using motion::bus::SlaveKind;

constexpr uint8_t kTerminalBits = 16;
constexpr int kBitsMax = 32;
constexpr int kGapBitsMax = 255;
constexpr std::string_view kGapName = "gap";
constexpr std::string_view kProbeNames[] = {"probe1", "probe2"};

/// Takes the text up to the next colon.
std::string_view NextField(std::string_view* text) {
  const size_t colon = text->find(':');
  const std::string_view part = text->substr(0, colon);
  *text = colon == std::string_view::npos ? std::string_view() : text->substr(colon + 1);
  return part;
}

/// A whole number that is the whole text.
std::optional<int> NumberIn(std::string_view text, int base, int largest) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  const bool good = error == std::errc() && end == text.data() + text.size();
  return good && value >= 0 && value <= largest ? std::optional(value) : std::nullopt;
}

Error NotAnEntry(std::string_view text) {
  return MakeError(
      1,
      "'{0}' is not an entry of process data: expected index[:subindex[:bits]] as in "
      "\"6040\" or \"7010:1:16\", or \"gap:8\"",
      "“{0}”不是过程数据的条目：应为 索引[:子索引[:位数]]，如 \"6040\"、\"7010:1:16\"，"
      "或 \"gap:8\"",
      text);
}

/// The object of a drive that a text without subindex means: subindex 0, or 1 if that is a number
/// of entries.
std::optional<ObjectId> DriveObject(uint16_t index, std::optional<int> subindex) {
  if (subindex) return motion::bus::FindObject(index, static_cast<uint8_t>(*subindex));
  const auto first = motion::bus::FindObject(index, 1);
  return first ? first : motion::bus::FindObject(index, 0);
}

}  // namespace

Result<PdoEntry> ParsePdoEntry(std::string_view text, SlaveKind kind) {
  std::string_view rest = text;
  const std::string_view name = NextField(&rest);
  std::optional<int> subindex;
  if (name != kGapName && !rest.empty()) {
    subindex = NumberIn(NextField(&rest), 10, 255);
    if (!subindex) return NotAnEntry(text);
  }
  std::optional<int> bits;
  if (!rest.empty()) {
    bits = NumberIn(rest, 10, name == kGapName ? kGapBitsMax : kBitsMax);
    if (!bits || *bits == 0) return NotAnEntry(text);
  }
  if (name == kGapName) {
    if (!bits) return NotAnEntry(text);
    return PdoEntry{0, 0, static_cast<uint8_t>(*bits)};
  }
  const auto index = NumberIn(name, 16, 0xFFFF);
  if (!index || *index == 0) return NotAnEntry(text);
  const auto number = static_cast<uint16_t>(*index);
  if (kind != SlaveKind::kDrive) {
    return PdoEntry{number, static_cast<uint8_t>(subindex.value_or(1)),
                    static_cast<uint8_t>(bits.value_or(kTerminalBits))};
  }
  const auto object = DriveObject(number, subindex);
  if (!object) {
    return MakeError(1, "a drive has no object '{0}'", "驱动器没有对象“{0}”", text);
  }
  const ObjectEntry& entry = EntryOf(*object);
  const auto length = static_cast<int>(8 * entry.bytes());
  if (bits.value_or(length) != length) {
    return MakeError(1, "object '{0}' has {1} bits", "对象“{0}”为 {1} 位", text, length);
  }
  return PdoEntry{entry.index, entry.subindex, static_cast<uint8_t>(length)};
}

std::string FormatPdoEntry(const PdoEntry& entry) {
  if (entry.index == 0) return fmt::format("{}:{}", kGapName, entry.bits);
  return fmt::format("{:04X}:{}:{}", entry.index, entry.subindex, entry.bits);
}

Slave SlaveOf(const BusSlaveSetup& setup) {
  Slave slave = motion::bus::DefaultSlave(setup.kind);
  slave.axis = static_cast<int8_t>(setup.axis - 1);
  if (setup.vendor) slave.vendor = static_cast<uint32_t>(*setup.vendor);
  if (setup.product) slave.product = static_cast<uint32_t>(*setup.product);
  const auto replace = [&](const std::vector<std::string>& texts, std::vector<PdoEntry>& entries) {
    if (texts.empty()) return;
    entries.clear();
    if (texts.size() == 1 && texts.front() == kNoEntries) return;
    for (const std::string& text : texts) {
      if (const auto entry = ParsePdoEntry(text, setup.kind); entry.ok()) {
        entries.push_back(entry.value());
      }
    }
  };
  replace(setup.outputs, slave.outputs);
  replace(setup.inputs, slave.inputs);
  return slave;
}

BusSlaveSetup SetupOf(const Slave& slave) {
  BusSlaveSetup setup;
  setup.kind = slave.kind;
  setup.axis = slave.axis + 1;
  setup.vendor = slave.vendor;
  setup.product = slave.product;
  const auto spell = [](const std::vector<PdoEntry>& entries, std::vector<std::string>& texts) {
    for (const PdoEntry& entry : entries) texts.push_back(FormatPdoEntry(entry));
    if (texts.empty()) texts.emplace_back(kNoEntries);
  };
  spell(slave.outputs, setup.outputs);
  spell(slave.inputs, setup.inputs);
  return setup;
}

std::optional<BusTerminal> FindTerminal(const Slave& slave, std::string_view object) {
  const bool drive = slave.kind == SlaveKind::kDrive;
  for (uint16_t i = 0; i < std::size(kProbeNames) && drive; ++i) {
    if (object == kProbeNames[i]) return BusTerminal{true, i};
  }
  const auto entry = ParsePdoEntry(object, slave.kind);
  if (!entry.ok()) return std::nullopt;
  const uint16_t index = entry.value().index;
  if (drive) {
    const auto id = motion::bus::FindObject(index, entry.value().subindex);
    const bool terminal = id == ObjectId::kDigitalInputs || id == ObjectId::kAnalogInput1 ||
                          id == ObjectId::kAnalogInput2;
    if (!terminal) return std::nullopt;
    return BusTerminal{false, static_cast<uint16_t>(*id)};
  }
  for (size_t i = 0; i < slave.inputs.size(); ++i) {
    const PdoEntry& input = slave.inputs[i];
    if (input.index != 0 && input.index == index && input.subindex == entry.value().subindex) {
      return BusTerminal{false, static_cast<uint16_t>(i)};
    }
  }
  return std::nullopt;
}

}  // namespace oncard::runtime
