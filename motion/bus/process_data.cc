#include "motion/bus/process_data.h"

#include <optional>

namespace oncard::motion::bus {

static_assert(8 * kImageMax < 0xFFFF);

MappedObjects::MappedObjects(const std::vector<PdoEntry>& entries, size_t bit) {
  numbers_.fill(kNone);
  for (const PdoEntry& entry : entries) {
    if (const std::optional<ObjectId> id = FindObject(entry.index, entry.subindex)) {
      uint16_t& number = numbers_[static_cast<size_t>(*id)];
      if (number == kNone) number = static_cast<uint16_t>(objects_.size());
      objects_.push_back({*id, {bit, entry.bits}, EntryOf(*id).is_signed()});
    }
    bit += entry.bits;
  }
}

std::vector<MappedSlave> MapSlaves(const Slaves& slaves) {
  const std::vector<SlavePlace> places = PlacesOf(slaves);
  std::vector<MappedSlave> mapped;
  for (size_t i = 0; i < slaves.size(); ++i) {
    mapped.push_back({places[i], MappedObjects(slaves[i].outputs, 8 * places[i].outputs),
                      MappedObjects(slaves[i].inputs, 8 * places[i].inputs)});
  }
  return mapped;
}

}  // namespace oncard::motion::bus
