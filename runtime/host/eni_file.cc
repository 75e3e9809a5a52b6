#include "runtime/host/eni_file.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <rapidxml/rapidxml.hpp>
#include <set>
#include <utility>

#include "base/files.h"
#include "motion/bus/objects.h"
#include "motion/common/sizes.h"
#include "runtime/host/xml_text.h"

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
/// A PdoEntry has at most so many bits; longer gaps are several entries.
constexpr int64_t kGapBitsMax = 255;
constexpr int64_t kU16Max = 65'535;
constexpr int64_t kI32Min = std::numeric_limits<int32_t>::min();
constexpr int64_t kU32Max = std::numeric_limits<uint32_t>::max();

using Node = rapidxml::xml_node<>;

/// The first child of that name; null if there is none, or no parent.
const Node* Child(const Node* parent, const char* name) {
  return parent != nullptr ? parent->first_node(name) : nullptr;
}

std::vector<const Node*> Children(const Node* parent, const char* name) {
  std::vector<const Node*> children;
  for (const Node* node = Child(parent, name); node != nullptr; node = node->next_sibling(name)) {
    children.push_back(node);
  }
  return children;
}

/// The text of an element, also in CDATA or around a comment, without blanks at its ends.
std::string TextOf(const Node* node) {
  std::string text;
  for (const Node* part = Child(node, nullptr); part != nullptr; part = part->next_sibling()) {
    if (part->type() != rapidxml::node_element) text.append(part->value(), part->value_size());
  }
  constexpr std::string_view kBlanks = " \t\r\n";
  const size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

/// A whole number as ENI files write it: `17`, `#x11`, `0x11`.
std::optional<int64_t> ReadNumber(std::string_view text) {
  int base = 10;
  if (text.starts_with("#x") || text.starts_with("0x") || text.starts_with("0X")) {
    base = 16;
    text.remove_prefix(2);
    if (text.starts_with("-")) return std::nullopt;
  }
  int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

class EniReader {
 public:
  EniReader(std::string_view text, std::string path)
      : text_(IsUtf16(text) ? Utf8Of(text) : std::string(text)),
        parsed_(text_),
        path_(std::move(path)) {}

  Result<Slaves> Read() {
    if (!Parse()) return *std::move(error_);
    const Node* config = Child(Child(document_.get(), "EtherCATConfig"), "Config");
    if (config == nullptr) {
      Fail(size_t{0}, {"not an ENI file: the element EtherCATConfig/Config is missing",
                       "不是 ENI 文件：缺少元素 EtherCATConfig/Config"});
    } else if (const Node* next = config->next_sibling("Config")) {
      Fail(next, {"a second bus: a card has one, with one element Config",
                  "第二条总线：一张卡只有一条总线，即一个 Config 元素"});
    } else if (Child(config, "Slave") == nullptr) {
      Fail(config, {"the file describes no slave", "文件没有描述任何从站"});
    }
    Slaves slaves;
    for (const Node* node : Children(config, "Slave")) {
      if (error_) break;
      CheckAddress(Child(Child(node, "Info"), "PhysAddr"));
      slaves.push_back(ReadSlave(node));
      if (slaves.size() > motion::bus::kSlaveMax || ImageSize(slaves) > motion::bus::kImageMax) {
        Fail(node, MakeMessage("more than {0} slaves, or {1} bytes of process data",
                               "超过 {0} 个从站，或过程数据超过 {1} 字节", motion::bus::kSlaveMax,
                               motion::bus::kImageMax));
      }
    }
    if (error_) return *std::move(error_);
    NumberAxes(&slaves);
    return slaves;
  }

 private:
  /// False for a text that is no XML.
  bool Parse() {
    if (const auto refusal = CheckXml(text_)) {
      Fail(refusal->offset, refusal->why);
      return false;
    }
    try {
      document_->parse<rapidxml::parse_validate_closing_tags>(parsed_.data());
    } catch (const rapidxml::parse_error& error) {
      FailAsXml(OffsetOf(error.where<char>()), error.what());
      return false;
    }
    if (document_->first_node() != nullptr) return true;
    FailAsXml(text_.size(), "there is no element");
    return false;
  }

  void FailAsXml(size_t offset, const char* what) {
    Fail(offset, MakeMessage("not XML: {0}", "不符合 XML 语法：{0}", what));
  }

  Slave ReadSlave(const Node* node) {
    Slave slave;
    const Node* info = Child(node, "Info");
    // Numbers with the highest bit may be written as negative ones.
    slave.vendor = static_cast<uint32_t>(Number(node, info, "VendorId", kU32Max, kI32Min));
    slave.product = static_cast<uint32_t>(Number(node, info, "ProductCode", kU32Max, kI32Min));
    const Node* data = Child(node, "ProcessData");
    slave.outputs = ReadPdos(data, "RxPdo");
    slave.inputs = ReadPdos(data, "TxPdo");
    CheckLength(data, "Send", slave.outputs);
    CheckLength(data, "Recv", slave.inputs);
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

  std::vector<PdoEntry> ReadPdos(const Node* data, const char* name) {
    const std::vector<const Node*> pdos = Children(data, name);
    const auto assigned = [](const Node* pdo) { return pdo->first_attribute("Sm") != nullptr; };
    const bool some = std::ranges::any_of(pdos, assigned);
    std::vector<PdoEntry> entries;
    for (const Node* pdo : pdos) {
      if (some && !assigned(pdo)) continue;
      for (const Node* entry : Children(pdo, "Entry")) {
        // An entry has at least one bit, so the image is too large then.
        if (entries.size() > 8 * motion::bus::kImageMax || error_) return entries;
        ReadEntry(entry, &entries);
      }
    }
    return entries;
  }

  void ReadEntry(const Node* node, std::vector<PdoEntry>* entries) {
    const auto index = static_cast<uint16_t>(Number(node, node, "Index", kU16Max));
    int64_t bits = Number(node, node, "BitLen", kU16Max);
    // A gap, and an object that is one number, may have no subindex.
    const bool numbered = index != 0 && Child(node, "SubIndex") != nullptr;
    const int64_t subindex = numbered ? Number(node, node, "SubIndex", 255) : 0;
    if (bits == 0) {
      Fail(node, {"BitLen is 0: an entry has at least 1 bit", "BitLen 为 0：条目至少 1 位"});
    } else if (bits <= kEntryBitsMax) {
      entries->push_back({index, static_cast<uint8_t>(subindex), static_cast<uint8_t>(bits)});
      return;
    }
    for (; bits > 0; bits -= kGapBitsMax) {
      entries->push_back({0, 0, static_cast<uint8_t>(std::min(bits, kGapBitsMax))});
    }
  }

  /// Two slaves cannot have the same fixed address.
  void CheckAddress(const Node* node) {
    if (node == nullptr) return;
    const int64_t address = Number(node, node->parent(), "PhysAddr", kU16Max);
    if (addresses_.insert(address).second) return;
    Fail(node, MakeMessage("PhysAddr {0} belongs to another slave", "PhysAddr {0} 已属于另一个从站",
                           address));
  }

  /// A drive's objects have the length of its dictionary.
  void FitToDrive(const Node* data, std::vector<PdoEntry>* entries) {
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

  /// The image has as many bits as the objects in it, up to whole bytes. It may be in parts.
  void CheckLength(const Node* data, const char* name, const std::vector<PdoEntry>& entries) {
    const Node* image = Child(data, name);
    if (image == nullptr) return;
    int64_t bits = 0;
    for (const Node* part : Children(data, name)) {
      bits += Number(part, part, "BitLength", kU32Max);
    }
    if (static_cast<size_t>((bits + 7) / 8) == BytesOf(entries)) return;
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
  int64_t Number(const Node* place, const Node* parent, const char* name, int64_t largest,
                 int64_t smallest = 0) {
    const Node* node = Child(parent, name);
    const std::string text = TextOf(node);
    const std::optional<int64_t> value = ReadNumber(text);
    if (value && *value >= smallest && *value <= largest) return *value;
    Fail(node != nullptr ? node : place,
         MakeMessage("{0} is '{1}': a number from {3} to {2} is expected",
                     "{0} 为“{1}”：应为 {3} 至 {2} 的数", name, text, largest, smallest));
    return 0;
  }

  size_t OffsetOf(const char* place) const { return static_cast<size_t>(place - parsed_.data()); }

  void Fail(const Node* node, const Message& message) { Fail(OffsetOf(node->name()), message); }

  /// The first mistake counts.
  void Fail(size_t offset, const Message& message) {
    if (error_) return;
    const std::string_view before = std::string_view(text_).substr(0, offset);
    const auto line = 1 + std::ranges::count(before, '\n');
    const size_t begin = before.rfind('\n');
    const size_t column = before.size() - (begin == std::string_view::npos ? 0 : begin + 1) + 1;
    error_ = MakeError(1, "{0}:{1}:{2}: {3}", "{0}:{1}:{2}: {4}", path_, line, column, message.en,
                       message.zh);
  }

  const std::string text_;
  std::string parsed_;  ///< the same, in which the parser marks ends and replaces references
  const std::string path_;
  // It begins with a large block of memory.
  const std::unique_ptr<rapidxml::xml_document<>> document_ =
      std::make_unique<rapidxml::xml_document<>>();
  std::set<int64_t> addresses_;
  std::optional<Error> error_;
};

}  // namespace

Result<Slaves> ParseEni(std::string_view text, const std::string& path) {
  return EniReader(text, path).Read();
}

}  // namespace oncard::runtime
