// Writes ENI files. What they contain are numbers and words of ours, so nothing is escaped.
#include <fmt/format.h>

#include <string>

#include "runtime/host/eni_file.h"

namespace oncard::runtime {
namespace {

using motion::bus::PdoEntry;
using motion::bus::Slave;
using motion::bus::SlavePlace;
using motion::bus::Slaves;

/// Indices of the PDOs and numbers of the sync managers that devices usually have (ETG.1000.6).
constexpr int kRxPdo = 0x1600;
constexpr int kTxPdo = 0x1A00;
constexpr int kOutputManager = 2;
constexpr int kInputManager = 3;
/// Fixed addresses begin here (ETG.2100).
constexpr int kFirstAddress = 1001;

/// A text of elements, each in a line, indented by its depth.
class ElementText {
 public:
  /// Begins an element with an attribute, if one is given, as in `Sm="2"`.
  void Begin(std::string_view name, const std::string& attribute = {}) {
    Line(fmt::format("<{}{}{}>", name, attribute.empty() ? "" : " ", attribute));
    ++depth_;
  }
  void End(std::string_view name) {
    --depth_;
    Line(fmt::format("</{}>", name));
  }
  template <typename Value>
  void Add(std::string_view name, const Value& value) {
    Line(fmt::format("<{0}>{1}</{0}>", name, value));
  }
  const std::string& text() const { return text_; }

 private:
  void Line(const std::string& line) { text_ += std::string(2 * depth_, ' ') + line + '\n'; }

  std::string text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  size_t depth_ = 0;
};

/// An index as ENI files write it: `#x6040`.
void AddIndex(ElementText& text, int index) { text.Add("Index", fmt::format("#x{:04X}", index)); }

void AddImage(ElementText& text, std::string_view element, size_t first_byte, size_t bytes) {
  if (bytes == 0) return;
  text.Begin(element);
  text.Add("BitStart", 8 * first_byte);
  text.Add("BitLength", 8 * bytes);
  text.End(element);
}

void AddPdo(ElementText& text, std::string_view element, int index, int manager,
            const std::vector<PdoEntry>& entries) {
  if (entries.empty()) return;
  text.Begin(element, fmt::format("Sm=\"{}\"", manager));
  AddIndex(text, index);
  for (const PdoEntry& entry : entries) {
    text.Begin("Entry");
    AddIndex(text, entry.index);
    if (entry.index != 0) text.Add("SubIndex", entry.subindex);
    text.Add("BitLen", entry.bits);
    text.End("Entry");
  }
  text.End(element);
}

void AddSlave(ElementText& text, const Slave& slave, size_t number, const SlavePlace& place) {
  text.Begin("Slave");
  text.Begin("Info");
  const std::string_view kind = motion::bus::kSlaveKindNames[static_cast<size_t>(slave.kind)];
  text.Add("Name", fmt::format("{} {}", kind, number));
  text.Add("PhysAddr", kFirstAddress + static_cast<int>(number));
  text.Add("VendorId", slave.vendor);
  text.Add("ProductCode", slave.product);
  text.End("Info");
  text.Begin("ProcessData");
  AddImage(text, "Send", place.outputs, place.output_bytes);
  AddImage(text, "Recv", place.inputs, place.input_bytes);
  AddPdo(text, "RxPdo", kRxPdo, kOutputManager, slave.outputs);
  AddPdo(text, "TxPdo", kTxPdo, kInputManager, slave.inputs);
  text.End("ProcessData");
  text.End("Slave");
}

}  // namespace

std::string FormatEni(const Slaves& slaves) {
  ElementText text;
  text.Begin("EtherCATConfig", "Version=\"1.3\"");
  text.Begin("Config");
  const std::vector<SlavePlace> places = PlacesOf(slaves);
  for (size_t i = 0; i < slaves.size(); ++i) AddSlave(text, slaves[i], i, places[i]);
  text.End("Config");
  text.End("EtherCATConfig");
  return text.text();
}

}  // namespace oncard::runtime
