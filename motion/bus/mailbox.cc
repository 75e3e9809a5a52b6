// The mailbox of the bus: uploads and downloads of objects (SDO).
#include <algorithm>
#include <string_view>

#include "motion/bus/bus.h"

namespace oncard::motion::bus {
namespace {

constexpr uint16_t kDeviceName = 0x1008;
constexpr uint16_t kLastOfIdentity = 0x1018;

/// What 1008h says, in the order of SlaveKind.
constexpr std::string_view kDeviceNames[] = {"oncard drive", "oncard I/O", "oncard coupler"};

std::vector<uint8_t> BytesOfNumber(int64_t value, size_t bytes) {
  std::vector<uint8_t> data(bytes);
  WriteNumber(value, data);
  return data;
}

/// Objects that cannot change while the drive moves by them.
bool BelongsToHoming(ObjectId id) {
  return id == ObjectId::kHomeOffset ||
         (id >= ObjectId::kHomingMethod && id <= ObjectId::kHomingAcceleration);
}

SdoAbort CheckValue(ObjectId id, int64_t value) {
  if (id == ObjectId::kMode && !IsSupportedMode(value)) return SdoAbort::kRange;
  if (id == ObjectId::kHomingMethod && !FindHomingMethod(value)) return SdoAbort::kRange;
  return SdoAbort::kNone;
}

/// The abort code for an object that is not in process data.
SdoAbort WhyNoTerminal(const Slave& slave, uint16_t index) {
  const auto same = [index](const PdoEntry& entry) { return entry.index == index; };
  const bool exists =
      std::ranges::any_of(slave.inputs, same) || std::ranges::any_of(slave.outputs, same);
  return index != 0 && exists ? SdoAbort::kNoSubindex : SdoAbort::kNoObject;
}

}  // namespace

SdoAbort Bus::Upload(size_t number, uint16_t index, uint8_t subindex,
                     std::vector<uint8_t>* data) const {
  if (!MailboxWorks(number)) return SdoAbort::kTimeout;
  const Slave& slave = (*connected_)[number];
  if (index == kDeviceName) {
    if (subindex != 0) return SdoAbort::kNoSubindex;
    const std::string_view name = kDeviceNames[static_cast<size_t>(slave.kind)];
    data->assign(name.begin(), name.end());
    return SdoAbort::kNone;
  }
  const std::optional<BusDrive>& drive = slaves_[number].drive;
  if (!drive && index > kLastOfIdentity) return UploadTerminal(number, index, subindex, data);
  const std::optional<ObjectId> id = FindObject(index, subindex);
  if (!id) return WhyMissing(index);
  const ObjectEntry& entry = EntryOf(*id);
  if (const SdoAbort abort = CheckUpload(entry); abort != SdoAbort::kNone) return abort;
  ObjectValues identity;
  identity.Set(ObjectId::kDeviceType, 0);
  identity.Set(ObjectId::kVendor, slave.vendor);
  identity.Set(ObjectId::kProduct, slave.product);
  *data = BytesOfNumber(drive ? drive->values()[*id] : identity[*id], entry.bytes());
  return SdoAbort::kNone;
}

SdoAbort Bus::Download(size_t number, uint16_t index, uint8_t subindex,
                       std::span<const uint8_t> data) {
  if (!MailboxWorks(number)) return SdoAbort::kTimeout;
  if (index == kDeviceName) return subindex == 0 ? SdoAbort::kReadOnly : SdoAbort::kNoSubindex;
  std::optional<BusDrive>& drive = slaves_[number].drive;
  if (!drive && index > kLastOfIdentity) return DownloadTerminal(number, index, subindex, data);
  const std::optional<ObjectId> id = FindObject(index, subindex);
  if (!id) return WhyMissing(index);
  const ObjectEntry& entry = EntryOf(*id);
  SdoAbort abort = CheckDownload(entry, data);
  if (abort != SdoAbort::kNone) return abort;
  const int64_t value = ReadNumber(data, entry.is_signed());
  abort = CheckValue(*id, value);
  if (abort != SdoAbort::kNone) return abort;
  // Only drives have objects that can be written.
  if (BelongsToHoming(*id) && drive->homing().running()) return SdoAbort::kState;
  drive->values().Set(*id, value);
  return SdoAbort::kNone;
}

SdoAbort Bus::UploadTerminal(size_t number, uint16_t index, uint8_t subindex,
                             std::vector<uint8_t>* data) const {
  const Slave& slave = (*connected_)[number];
  if (index != 0) {
    if (const auto entry = FindEntry(slave.outputs, index, subindex)) {
      const int64_t value = image_.Get(8 * place(number).outputs + entry->bit, entry->bits, false);
      *data = BytesOfNumber(value, (entry->bits + 7u) / 8u);
      return SdoAbort::kNone;
    }
    if (const auto entry = FindEntry(slave.inputs, index, subindex)) {
      const int64_t value = slaves_[number].inputs.Get(entry->bit, entry->bits, false);
      *data = BytesOfNumber(value, (entry->bits + 7u) / 8u);
      return SdoAbort::kNone;
    }
  }
  return WhyNoTerminal(slave, index);
}

SdoAbort Bus::DownloadTerminal(size_t number, uint16_t index, uint8_t subindex,
                               std::span<const uint8_t> data) {
  const Slave& slave = (*connected_)[number];
  if (index != 0 && FindEntry(slave.inputs, index, subindex)) return SdoAbort::kReadOnly;
  const auto entry = index == 0 ? std::nullopt : FindEntry(slave.outputs, index, subindex);
  if (!entry) return WhyNoTerminal(slave, index);
  if (data.size() != (entry->bits + 7u) / 8u) return SdoAbort::kLength;
  image_.Put(8 * place(number).outputs + entry->bit, entry->bits, ReadNumber(data, false));
  return SdoAbort::kNone;
}

}  // namespace oncard::motion::bus
