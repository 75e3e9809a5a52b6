// The object dictionary of a drive: its entries (objects.def), their values, and the services that
// read and write them (SDO) with the standard abort codes. Data are little-endian. Not thread-safe.
// Source: CiA 402, ETG.1000.6 (abort codes). Tested by tests/motion/bus/objects_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace oncard::motion::bus {

enum class ObjectType : uint8_t { kU8, kI8, kU16, kI16, kU32, kI32 };
enum class ObjectAccess : uint8_t { kReadOnly, kReadWrite, kWriteOnly };

/// The entries of a drive's dictionary.
enum class ObjectId : uint8_t {
#define OBJECT(id, ...) id,
#include "motion/bus/objects.def"
  kCount
};
inline constexpr size_t kObjectCount = static_cast<size_t>(ObjectId::kCount);

/// Why a service ended without effect (ETG.1000.6).
enum class SdoAbort : uint32_t {
  kNone = 0,
  kTimeout = 0x0504'0000,
  kWriteOnly = 0x0601'0001,
  kReadOnly = 0x0601'0002,
  kNoObject = 0x0602'0000,
  kLength = 0x0607'0010,
  kNoSubindex = 0x0609'0011,
  kRange = 0x0609'0030,
  kState = 0x0800'0022
};

struct ObjectEntry {
  uint16_t index = 0;
  uint8_t subindex = 0;
  ObjectType type = ObjectType::kU8;
  ObjectAccess access = ObjectAccess::kReadOnly;
  int64_t initial = 0;
  int64_t smallest = 0;
  int64_t largest = 0;

  size_t bytes() const;
  bool is_signed() const;
};

/// All entries, in the order of ObjectId.
std::span<const ObjectEntry> ObjectEntries();
inline const ObjectEntry& EntryOf(ObjectId id) { return ObjectEntries()[static_cast<size_t>(id)]; }
/// The entry with that number; empty if there is none.
std::optional<ObjectId> FindObject(uint16_t index, uint8_t subindex);

/// A little-endian number of 1, 2 or 4 bytes.
int64_t ReadNumber(std::span<const uint8_t> bytes, bool is_signed);
void WriteNumber(int64_t value, std::span<uint8_t> bytes);

/// The values of a drive's dictionary.
class ObjectValues {
 public:
  ObjectValues();

  int64_t operator[](ObjectId id) const { return values_[static_cast<size_t>(id)]; }
  /// Sets what the drive itself knows; numbers outside of the type wrap.
  void Set(ObjectId id, int64_t value);

  auto Fields(auto visit) const { return visit(values_); }

 private:
  std::array<int64_t, kObjectCount> values_{};
};

/// What an entry says to an upload, and to a download of so many bytes with that value.
SdoAbort CheckUpload(const ObjectEntry& entry);
SdoAbort CheckDownload(const ObjectEntry& entry, std::span<const uint8_t> data);

/// The abort code for an entry that does not exist.
SdoAbort WhyMissing(uint16_t index);

}  // namespace oncard::motion::bus
