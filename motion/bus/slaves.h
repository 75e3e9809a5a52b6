// What slaves are: their kinds, identities and process data, as an ENI file or a scenario describes
// them, and where their data is in the process image of the bus. Constant while a bus is up. Tested
// by tests/motion/bus/slaves_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace oncard::motion::bus {

enum class SlaveKind : uint8_t { kDrive, kIo, kCoupler };

/// `drive` `io` `coupler`, in the order of SlaveKind.
inline constexpr std::string_view kSlaveKindNames[] = {"drive", "io", "coupler"};

/// An object, or a gap of some bits (index 0), in the process data of a slave.
struct PdoEntry {
  uint16_t index = 0;
  uint8_t subindex = 0;
  uint8_t bits = 0;  ///< 1 to 32

  auto Fields(auto visit) const { return visit(index, subindex, bits); }
  bool operator==(const PdoEntry&) const = default;
};

/// One slave.
struct Slave {
  SlaveKind kind = SlaveKind::kIo;
  int8_t axis = -1;  ///< of a drive: the axis of the card, from 0
  uint32_t vendor = 0;
  uint32_t product = 0;
  std::vector<PdoEntry> outputs;  ///< RxPdo: from the controller to the slave
  std::vector<PdoEntry> inputs;   ///< TxPdo

  auto Fields(auto visit) const { return visit(kind, axis, vendor, product, outputs, inputs); }
  bool operator==(const Slave&) const = default;
};

/// In the order of the line.
using Slaves = std::vector<Slave>;
using SlavesPointer = std::shared_ptr<const Slaves>;

/// Capacity: slaves of a bus, and bytes of its process image.
inline constexpr size_t kSlaveMax = 64;
inline constexpr size_t kImageMax = 1486;  ///< the data of one EtherCAT datagram

// Assumption: identities of slaves that name none, and their process data: those of the manual's
// example, two drives of 16 bytes and digital I/O of 16 bits (GTS manual S2, 5.2.2.4).
inline constexpr uint32_t kDefaultVendor = 0x0000'02E1;
inline constexpr uint32_t kDefaultDriveProduct = 0x0000'0402;
inline constexpr uint32_t kDefaultIoProduct = 0x0000'0401;
inline constexpr uint32_t kDefaultCouplerProduct = 0x0000'1389;

/// A slave of a kind with its default identity and process data.
Slave DefaultSlave(SlaveKind kind);

/// Where the process data of one slave is in the image, in bytes: outputs, then inputs.
struct SlavePlace {
  size_t outputs = 0;
  size_t output_bytes = 0;
  size_t inputs = 0;
  size_t input_bytes = 0;

  size_t end() const { return inputs + input_bytes; }
};

/// The whole bytes that process data takes.
size_t BytesOf(const std::vector<PdoEntry>& entries);
/// The places of all slaves, one after the other without gaps.
std::vector<SlavePlace> PlacesOf(const Slaves& slaves);
/// Bytes of the image.
size_t ImageSize(const Slaves& slaves);

/// An object in process data: its first bit, and its length.
struct EntryPlace {
  size_t bit = 0;
  uint8_t bits = 0;
};
std::optional<EntryPlace> FindEntry(const std::vector<PdoEntry>& entries, uint16_t index,
                                    uint8_t subindex);

/// The first place at which connected slaves differ from configured ones.
struct SlaveDifference {
  enum class What : uint8_t { kMissing, kUnexpected, kIdentity, kProcessData };
  What what = What::kMissing;
  size_t slave = 0;  ///< its number, from 0
};
std::optional<SlaveDifference> FirstDifference(const Slaves& configured, const Slaves& connected);

}  // namespace oncard::motion::bus
