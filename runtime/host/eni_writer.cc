// Writes ENI files. Apart from the reader, which needs an XML library.
#include <fmt/format.h>

#include "runtime/host/eni_file.h"

namespace oncard::runtime {
namespace {

using motion::bus::PdoEntry;
using motion::bus::Slave;
using motion::bus::Slaves;

/// Indices of the PDOs and numbers of the sync managers that devices usually have (ETG.1000.6).
constexpr int kRxPdo = 0x1600;
constexpr int kTxPdo = 0x1A00;
constexpr int kOutputManager = 2;
constexpr int kInputManager = 3;
/// Fixed addresses begin here (ETG.2100).
constexpr int kFirstAddress = 1001;

std::string FormatImage(std::string_view element, size_t first_byte, size_t bytes) {
  if (bytes == 0) return {};
  return fmt::format(
      "        <{0}>\n          <BitStart>{1}</BitStart>\n          <BitLength>{2}</BitLength>\n"
      "        </{0}>\n",
      element, 8 * first_byte, 8 * bytes);
}

std::string FormatPdo(std::string_view element, int index, int manager,
                      const std::vector<PdoEntry>& entries) {
  if (entries.empty()) return {};
  std::string text = fmt::format("        <{0} Sm=\"{1}\">\n          <Index>#x{2:04X}</Index>\n",
                                 element, manager, index);
  for (const PdoEntry& entry : entries) {
    text += fmt::format("          <Entry>\n            <Index>#x{:04X}</Index>\n", entry.index);
    if (entry.index != 0) {
      text += fmt::format("            <SubIndex>{}</SubIndex>\n", entry.subindex);
    }
    text += fmt::format("            <BitLen>{}</BitLen>\n          </Entry>\n", entry.bits);
  }
  return text + fmt::format("        </{}>\n", element);
}

}  // namespace

std::string FormatEni(const Slaves& slaves) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<EtherCATConfig Version=\"1.3\">\n  <Config>\n";
  const std::vector<motion::bus::SlavePlace> places = PlacesOf(slaves);
  for (size_t i = 0; i < slaves.size(); ++i) {
    const Slave& slave = slaves[i];
    const motion::bus::SlavePlace& place = places[i];
    text += fmt::format(
        "    <Slave>\n      <Info>\n        <Name>{} {}</Name>\n"
        "        <PhysAddr>{}</PhysAddr>\n        <VendorId>{}</VendorId>\n"
        "        <ProductCode>{}</ProductCode>\n      </Info>\n      <ProcessData>\n",
        motion::bus::kSlaveKindNames[static_cast<size_t>(slave.kind)], i,
        kFirstAddress + static_cast<int>(i), slave.vendor, slave.product);
    text += FormatImage("Send", place.outputs, place.output_bytes);
    text += FormatImage("Recv", place.inputs, place.input_bytes);
    text += FormatPdo("RxPdo", kRxPdo, kOutputManager, slave.outputs);
    text += FormatPdo("TxPdo", kTxPdo, kInputManager, slave.inputs);
    text += "      </ProcessData>\n    </Slave>\n";
  }
  return text + "  </Config>\n</EtherCATConfig>\n";
}

}  // namespace oncard::runtime
