// Where the objects of drives are in the process image: looked up once, when the bus starts, so
// that a cycle does not search for them. Constant while a bus is up. Tested by
// tests/motion/bus/process_data_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/bus/objects.h"
#include "motion/bus/slaves.h"

namespace oncard::motion::bus {

/// An object of the dictionary in process data.
struct MappedObject {
  ObjectId id = ObjectId::kCount;
  EntryPlace place;  ///< in the process image
  bool is_signed = false;
};

/// The objects of one slave in one direction, in the order of its process data. Gaps and what is
/// not in the dictionary are left out.
class MappedObjects {
 public:
  /// Process data that begins at that bit of the image.
  MappedObjects(const std::vector<PdoEntry>& entries, size_t bit);

  /// The first one with that ObjectId; nullptr if there is none.
  const MappedObject* Find(ObjectId id) const {
    const uint16_t number = numbers_[static_cast<size_t>(id)];
    return number == kNone ? nullptr : &objects_[number];
  }
  const std::vector<MappedObject>& all() const { return objects_; }

 private:
  static constexpr uint16_t kNone = 0xFFFF;  ///< an image has fewer bits

  std::vector<MappedObject> objects_;
  std::array<uint16_t, kObjectCount> numbers_{};  ///< in objects_
};

/// The process data of one slave.
struct MappedSlave {
  SlavePlace place;
  MappedObjects outputs;
  MappedObjects inputs;
};
std::vector<MappedSlave> MapSlaves(const Slaves& slaves);

}  // namespace oncard::motion::bus
