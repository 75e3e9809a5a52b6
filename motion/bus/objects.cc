#include "motion/bus/objects.h"

#include <algorithm>

namespace oncard::motion::bus {
namespace {

constexpr int64_t kI16Min = std::numeric_limits<int16_t>::min();
constexpr int64_t kI16Max = std::numeric_limits<int16_t>::max();
constexpr int64_t kI32Min = std::numeric_limits<int32_t>::min();
constexpr int64_t kI32Max = std::numeric_limits<int32_t>::max();
constexpr int64_t kU32Max = std::numeric_limits<uint32_t>::max();

constexpr ObjectEntry kEntries[] = {
#define OBJECT(id, index, subindex, type, access, initial, smallest, largest) \
  {index, subindex, ObjectType::type, ObjectAccess::access, initial, smallest, largest},
#include "motion/bus/objects.def"
};

int64_t NumberOf(const ObjectEntry& entry) { return int64_t{entry.index} << 8 | entry.subindex; }

static_assert(std::ranges::is_sorted(kEntries, {}, [](const ObjectEntry& entry) {
  return int64_t{entry.index} << 8 | entry.subindex;
}));

}  // namespace

size_t ObjectEntry::bytes() const {
  switch (type) {
    case ObjectType::kU8:
    case ObjectType::kI8:
      return 1;
    case ObjectType::kU16:
    case ObjectType::kI16:
      return 2;
    case ObjectType::kU32:
    case ObjectType::kI32:
      break;
  }
  return 4;
}

bool ObjectEntry::is_signed() const {
  return type == ObjectType::kI8 || type == ObjectType::kI16 || type == ObjectType::kI32;
}

std::span<const ObjectEntry> ObjectEntries() { return kEntries; }

std::optional<ObjectId> FindObject(uint16_t index, uint8_t subindex) {
  const int64_t number = int64_t{index} << 8 | subindex;
  const auto* entry = std::ranges::lower_bound(kEntries, number, {}, NumberOf);
  if (entry == std::end(kEntries) || NumberOf(*entry) != number) return std::nullopt;
  return static_cast<ObjectId>(entry - std::begin(kEntries));
}

int64_t ReadNumber(std::span<const uint8_t> bytes, bool is_signed) {
  uint64_t value = 0;
  for (size_t i = 0; i < bytes.size(); ++i) value |= uint64_t{bytes[i]} << (8 * i);
  if (!is_signed) return static_cast<int64_t>(value);
  const auto unused = static_cast<unsigned>(64 - 8 * bytes.size());
  return static_cast<int64_t>(value << unused) >> unused;
}

void WriteNumber(int64_t value, std::span<uint8_t> bytes) {
  for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<uint8_t>(value >> (8 * i));
}

ObjectValues::ObjectValues() {
  for (size_t i = 0; i < kObjectCount; ++i) values_[i] = kEntries[i].initial;
}

void ObjectValues::Set(ObjectId id, int64_t value) {
  const ObjectEntry& entry = EntryOf(id);
  const auto unused = static_cast<unsigned>(64 - 8 * entry.bytes());
  const uint64_t upper = static_cast<uint64_t>(value) << unused;
  values_[static_cast<size_t>(id)] = entry.is_signed() ? static_cast<int64_t>(upper) >> unused
                                                       : static_cast<int64_t>(upper >> unused);
}

SdoAbort CheckUpload(const ObjectEntry& entry) {
  return entry.access == ObjectAccess::kWriteOnly ? SdoAbort::kWriteOnly : SdoAbort::kNone;
}

SdoAbort CheckDownload(const ObjectEntry& entry, std::span<const uint8_t> data) {
  if (entry.access == ObjectAccess::kReadOnly) return SdoAbort::kReadOnly;
  if (data.size() != entry.bytes()) return SdoAbort::kLength;
  const int64_t value = ReadNumber(data, entry.is_signed());
  const bool inside = value >= entry.smallest && value <= entry.largest;
  return inside ? SdoAbort::kNone : SdoAbort::kRange;
}

SdoAbort WhyMissing(uint16_t index) {
  const bool exists = std::ranges::any_of(
      kEntries, [index](const ObjectEntry& entry) { return entry.index == index; });
  return exists ? SdoAbort::kNoSubindex : SdoAbort::kNoObject;
}

}  // namespace oncard::motion::bus
