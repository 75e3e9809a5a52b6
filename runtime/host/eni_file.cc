#include "runtime/host/eni_file.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <pugixml.hpp>
#include <utility>

#include "motion/bus/objects.h"
#include "motion/common/sizes.h"

namespace oncard::runtime {
namespace {

using motion::bus::PdoEntry;
using motion::bus::Slave;
using motion::bus::SlaveKind;
using motion::bus::Slaves;

constexpr uint16_t kControlWord = 0x6040;
constexpr uint16_t kCouplerStatus = 0xF100;
/// Longer entries are gaps.
constexpr int64_t kEntryBitsMax = 32;
constexpr int64_t kU32Max = 4'294'967'295;

/// A whole number as ENI files write it: `17`, `#x11`, `0x11`.
std::optional<int64_t> ReadNumber(std::string_view text) {
  int base = 10;
  if (text.starts_with("#x") || text.starts_with("0x")) {
    base = 16;
    text.remove_prefix(2);
  }
  int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

class EniReader {
 public:
  EniReader(std::string_view text, std::string path) : text_(text), path_(std::move(path)) {}

  Result<Slaves> Read() {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text_.data(), text_.size());
    if (!parsed) {
      Fail(parsed.offset,
           MakeMessage("not XML: {0}", "不符合 XML 语法：{0}", parsed.description()));
      return *std::move(error_);
    }
    const pugi::xml_node config = document.child("EtherCATConfig").child("Config");
    if (!config) {
      Fail(0, {"not an ENI file: the element EtherCATConfig/Config is missing",
               "不是 ENI 文件：缺少元素 EtherCATConfig/Config"});
    }
    Slaves slaves;
    for (const pugi::xml_node& node : config.children("Slave")) {
      slaves.push_back(ReadSlave(node));
      if (slaves.size() > motion::bus::kSlaveMax || ImageSize(slaves) > motion::bus::kImageMax) {
        Fail(node, MakeMessage("more than {0} slaves, or {1} bytes of process data",
                               "超过 {0} 个从站，或过程数据超过 {1} 字节", motion::bus::kSlaveMax,
                               motion::bus::kImageMax));
      }
      if (error_) break;
    }
    if (error_) return *std::move(error_);
    NumberAxes(&slaves);
    return slaves;
  }

 private:
  Slave ReadSlave(const pugi::xml_node& node) {
    Slave slave;
    const pugi::xml_node info = node.child("Info");
    slave.vendor = static_cast<uint32_t>(Number(node, info, "VendorId", kU32Max));
    slave.product = static_cast<uint32_t>(Number(node, info, "ProductCode", kU32Max));
    const pugi::xml_node data = node.child("ProcessData");
    slave.outputs = ReadPdos(data, "RxPdo");
    slave.inputs = ReadPdos(data, "TxPdo");
    CheckLength(data.child("Send"), slave.outputs);
    CheckLength(data.child("Recv"), slave.inputs);
    const auto has = [](const std::vector<PdoEntry>& entries, uint16_t index) {
      return std::ranges::any_of(entries,
                                 [index](const PdoEntry& entry) { return entry.index == index; });
    };
    if (has(slave.outputs, kControlWord)) {
      slave.kind = SlaveKind::kDrive;
      for (auto* entries : {&slave.outputs, &slave.inputs}) FitToDrive(data, entries);
    } else if (has(slave.inputs, kCouplerStatus)) {
      slave.kind = SlaveKind::kCoupler;
    }
    return slave;
  }

  std::vector<PdoEntry> ReadPdos(const pugi::xml_node& data, const char* name) {
    const auto pdos = data.children(name);
    const auto assigned = [](const pugi::xml_node& pdo) { return pdo.attribute("Sm") != nullptr; };
    const bool some = std::any_of(pdos.begin(), pdos.end(), assigned);
    std::vector<PdoEntry> entries;
    for (const pugi::xml_node& pdo : pdos) {
      if (some && !assigned(pdo)) continue;
      for (const pugi::xml_node& entry : pdo.children("Entry")) {
        if (entries.size() >= motion::bus::kImageMax || error_) return entries;
        entries.push_back(ReadEntry(entry));
      }
    }
    return entries;
  }

  PdoEntry ReadEntry(const pugi::xml_node& node) {
    PdoEntry entry;
    entry.index = static_cast<uint16_t>(Number(node, node, "Index", 0xFFFF));
    entry.bits = static_cast<uint8_t>(Number(node, node, "BitLen", 255));
    // A gap has no subindex.
    if (entry.index != 0) {
      entry.subindex = static_cast<uint8_t>(Number(node, node, "SubIndex", 255));
    }
    if (entry.bits == 0) {
      Fail(node, {"BitLen is 0: an entry has at least 1 bit", "BitLen 为 0：条目至少 1 位"});
    }
    if (entry.bits > kEntryBitsMax) entry = {0, 0, entry.bits};
    return entry;
  }

  /// A drive's objects have the length of its dictionary.
  void FitToDrive(const pugi::xml_node& data, std::vector<PdoEntry>* entries) {
    for (PdoEntry& entry : *entries) {
      const auto id = motion::bus::FindObject(entry.index, entry.subindex);
      if (!id) {
        entry.index = 0;
        entry.subindex = 0;
      } else if (8 * EntryOf(*id).bytes() != entry.bits) {
        Fail(data, MakeMessage("object {0:X}h of a drive has {1} bits, not {2}",
                               "驱动器的对象 {0:X}h 为 {1} 位，而不是 {2} 位", entry.index,
                               8 * EntryOf(*id).bytes(), entry.bits));
      }
    }
  }

  /// The image has as many bits as the objects in it, up to whole bytes.
  void CheckLength(const pugi::xml_node& image, const std::vector<PdoEntry>& entries) {
    if (!image) return;
    const auto bits = static_cast<size_t>(Number(image, image, "BitLength", kU32Max));
    if ((bits + 7) / 8 == BytesOf(entries)) return;
    Fail(image, MakeMessage("BitLength is {0}, but the objects take {1} bytes",
                            "BitLength 为 {0}，而对象共 {1} 字节", bits, BytesOf(entries)));
  }

  static void NumberAxes(Slaves* slaves) {
    int8_t axis = 0;
    for (Slave& slave : *slaves) {
      const bool drive = slave.kind == SlaveKind::kDrive;
      if (drive && axis < static_cast<int8_t>(motion::kAxisMax)) slave.axis = axis++;
    }
  }

  /// The number in an element; `place` is named if there is none.
  int64_t Number(const pugi::xml_node& place, const pugi::xml_node& parent, const char* name,
                 int64_t largest) {
    const pugi::xml_node node = parent.child(name);
    const std::optional<int64_t> value = ReadNumber(node.text().get());
    if (value && *value >= 0 && *value <= largest) return *value;
    Fail(node ? node : place,
         MakeMessage("{0} is '{1}': a number from 0 to {2} is expected",
                     "{0} 为“{1}”：应为 0 至 {2} 的数", name, node.text().get(), largest));
    return 0;
  }

  void Fail(const pugi::xml_node& node, const Message& message) {
    Fail(node.offset_debug(), message);
  }

  /// The first mistake counts.
  void Fail(std::ptrdiff_t offset, const Message& message) {
    if (error_) return;
    const auto end = static_cast<size_t>(std::max<std::ptrdiff_t>(offset, 0));
    const std::string_view before = text_.substr(0, std::min(end, text_.size()));
    const auto line = 1 + std::ranges::count(before, '\n');
    const size_t begin = before.rfind('\n');
    const size_t column = before.size() - (begin == std::string_view::npos ? 0 : begin + 1) + 1;
    error_ = MakeError(1, "{0}:{1}:{2}: {3}", "{0}:{1}:{2}: {4}", path_, line, column, message.en,
                       message.zh);
  }

  const std::string_view text_;
  const std::string path_;
  std::optional<Error> error_;
};

}  // namespace

Result<Slaves> ParseEni(std::string_view text, const std::string& path) {
  return EniReader(text, path).Read();
}

}  // namespace oncard::runtime
