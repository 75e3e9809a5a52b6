#include "motion/bus/slaves.h"

#include <algorithm>
#include <numeric>

namespace oncard::motion::bus {
namespace {

uint32_t DefaultProduct(SlaveKind kind) {
  switch (kind) {
    case SlaveKind::kDrive:
      return kDefaultDriveProduct;
    case SlaveKind::kIo:
      return kDefaultIoProduct;
    case SlaveKind::kCoupler:
      break;
  }
  return kDefaultCouplerProduct;
}

size_t BitsOf(const std::vector<PdoEntry>& entries) {
  return std::accumulate(entries.begin(), entries.end(), size_t{0},
                         [](size_t sum, const PdoEntry& entry) { return sum + entry.bits; });
}

}  // namespace

Slave DefaultSlave(SlaveKind kind) {
  Slave slave;
  slave.kind = kind;
  slave.vendor = kDefaultVendor;
  slave.product = DefaultProduct(kind);
  switch (kind) {
    case SlaveKind::kDrive:
      slave.outputs = {{0x6040, 0, 16}, {0x607A, 0, 32}};
      slave.inputs = {{0x6041, 0, 16}, {0x6064, 0, 32}, {0x60FD, 0, 32}};
      break;
    case SlaveKind::kIo:
      slave.outputs = {{0x7000, 1, 16}};
      slave.inputs = {{0x6000, 1, 16}};
      break;
    case SlaveKind::kCoupler:
      // A word of its own in each direction; digital inputs, digital outputs, four analogue inputs
      // and four analogue outputs in slots 0 to 3 (GTS manual S2, 5.2.2.5).
      slave.outputs = {{0xF200, 1, 16}, {0x7010, 1, 16}, {0x7030, 1, 16},
                       {0x7030, 2, 16}, {0x7030, 3, 16}, {0x7030, 4, 16}};
      slave.inputs = {{0xF100, 1, 16}, {0x6000, 1, 16}, {0x6020, 1, 16},
                      {0x6020, 2, 16}, {0x6020, 3, 16}, {0x6020, 4, 16}};
      break;
  }
  return slave;
}

size_t BytesOf(const std::vector<PdoEntry>& entries) { return (BitsOf(entries) + 7) / 8; }

std::vector<SlavePlace> PlacesOf(const Slaves& slaves) {
  std::vector<SlavePlace> places;
  size_t next = 0;
  for (const Slave& slave : slaves) {
    SlavePlace place;
    place.outputs = next;
    place.output_bytes = BytesOf(slave.outputs);
    place.inputs = place.outputs + place.output_bytes;
    place.input_bytes = BytesOf(slave.inputs);
    next = place.end();
    places.push_back(place);
  }
  return places;
}

size_t ImageSize(const Slaves& slaves) {
  size_t size = 0;
  for (const Slave& slave : slaves) size += BytesOf(slave.outputs) + BytesOf(slave.inputs);
  return size;
}

std::optional<EntryPlace> FindEntry(const std::vector<PdoEntry>& entries, uint16_t index,
                                    uint8_t subindex) {
  size_t bit = 0;
  for (const PdoEntry& entry : entries) {
    if (entry.index == index && entry.subindex == subindex) return EntryPlace{bit, entry.bits};
    bit += entry.bits;
  }
  return std::nullopt;
}

std::optional<SlaveDifference> FirstDifference(const Slaves& configured, const Slaves& connected) {
  using enum SlaveDifference::What;
  for (size_t number = 0; number < connected.size(); ++number) {
    if (number == configured.size()) return SlaveDifference{kUnexpected, number};
    const Slave& slave = connected[number];
    const Slave& wanted = configured[number];
    const bool other_kind = (wanted.kind == SlaveKind::kDrive) != (slave.kind == SlaveKind::kDrive);
    if (other_kind || wanted.vendor != slave.vendor || wanted.product != slave.product) {
      return SlaveDifference{kIdentity, number};
    }
    if (wanted.outputs != slave.outputs || wanted.inputs != slave.inputs) {
      return SlaveDifference{kProcessData, number};
    }
  }
  if (connected.size() < configured.size()) {
    return SlaveDifference{kMissing, connected.size()};
  }
  return std::nullopt;
}

}  // namespace oncard::motion::bus
