// Writes ENI files.
#include <fmt/format.h>

#include <pugixml.hpp>
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

template <typename Value>
void AddValue(pugi::xml_node parent, const char* element, const Value& value) {
  parent.append_child(element).text() = value;
}

/// An index as ENI files write it: `#x6040`.
void AddIndex(pugi::xml_node parent, int index) {
  AddValue(parent, "Index", fmt::format("#x{:04X}", index).c_str());
}

void AddImage(pugi::xml_node data, const char* element, size_t first_byte, size_t bytes) {
  if (bytes == 0) return;
  pugi::xml_node image = data.append_child(element);
  AddValue(image, "BitStart", static_cast<unsigned>(8 * first_byte));
  AddValue(image, "BitLength", static_cast<unsigned>(8 * bytes));
}

void AddPdo(pugi::xml_node data, const char* element, int index, int manager,
            const std::vector<PdoEntry>& entries) {
  if (entries.empty()) return;
  pugi::xml_node pdo = data.append_child(element);
  pdo.append_attribute("Sm") = manager;
  AddIndex(pdo, index);
  for (const PdoEntry& entry : entries) {
    pugi::xml_node child = pdo.append_child("Entry");
    AddIndex(child, entry.index);
    if (entry.index != 0) AddValue(child, "SubIndex", static_cast<unsigned>(entry.subindex));
    AddValue(child, "BitLen", static_cast<unsigned>(entry.bits));
  }
}

void AddSlave(pugi::xml_node config, const Slave& slave, size_t number, const SlavePlace& place) {
  pugi::xml_node element = config.append_child("Slave");
  pugi::xml_node info = element.append_child("Info");
  const std::string_view kind = motion::bus::kSlaveKindNames[static_cast<size_t>(slave.kind)];
  AddValue(info, "Name", fmt::format("{} {}", kind, number).c_str());
  AddValue(info, "PhysAddr", kFirstAddress + static_cast<int>(number));
  AddValue(info, "VendorId", slave.vendor);
  AddValue(info, "ProductCode", slave.product);
  pugi::xml_node data = element.append_child("ProcessData");
  AddImage(data, "Send", place.outputs, place.output_bytes);
  AddImage(data, "Recv", place.inputs, place.input_bytes);
  AddPdo(data, "RxPdo", kRxPdo, kOutputManager, slave.outputs);
  AddPdo(data, "TxPdo", kTxPdo, kInputManager, slave.inputs);
}

class TextWriter final : public pugi::xml_writer {
 public:
  void write(const void* data, size_t size) override {
    text.append(static_cast<const char*>(data), size);
  }
  std::string text;
};

}  // namespace

std::string FormatEni(const Slaves& slaves) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("EtherCATConfig");
  root.append_attribute("Version") = "1.3";
  pugi::xml_node config = root.append_child("Config");
  const std::vector<SlavePlace> places = PlacesOf(slaves);
  for (size_t i = 0; i < slaves.size(); ++i) AddSlave(config, slaves[i], i, places[i]);
  TextWriter writer;
  document.save(writer, "  ");
  return std::move(writer.text);
}

}  // namespace oncard::runtime
