#include "motion/bus/bus.h"

#include <algorithm>

namespace oncard::motion::bus {

Bus::Bus(SlavesPointer configured, SlavesPointer connected)
    : configured_(std::move(configured)), connected_(std::move(connected)) {
  for (const Slave& description : *connected_) {
    SlaveState& slave = slaves_.emplace_back();
    slave.inputs = ProcessImage(BytesOf(description.inputs));
    if (description.kind != SlaveKind::kDrive) continue;
    ObjectValues& values = slave.drive.emplace().values();
    values.Set(ObjectId::kVendor, description.vendor);
    values.Set(ObjectId::kProduct, description.product);
  }
}

// --- Communication -------------------------------------------------------------------------------

InitOutcome Bus::CheckInit() const {
  if (configured_ == nullptr) return InitOutcome::kNoConfiguration;
  if (slaves_.empty() || slaves_.front().lost) return InitOutcome::kNoSlaves;
  const bool lost = !Online(slaves_.size() - 1);
  const bool different = lost || FirstDifference(*configured_, *connected_).has_value();
  return different ? InitOutcome::kDifferent : InitOutcome::kDone;
}

InitOutcome Bus::Init(Micros now) {
  if (const InitOutcome outcome = CheckInit(); outcome != InitOutcome::kDone) return outcome;
  Terminate();
  places_ = PlacesOf(*configured_);
  image_ = ProcessImage(ImageSize(*configured_));
  phase_ = BusPhase::kInit;
  step_at_ = now;
  return InitOutcome::kDone;
}

void Bus::Terminate() {
  phase_ = BusPhase::kDown;
  started_ = false;
  for (SlaveState& slave : slaves_) {
    if (slave.drive) slave.drive->Disable();
  }
}

bool Bus::AdvancePhase(Micros now) {
  if (phase_ == BusPhase::kDown || phase_ == BusPhase::kOp) return false;
  if (now - step_at_ < kBusStepUs) return false;
  phase_ = static_cast<BusPhase>(static_cast<int>(phase_) + 1);
  step_at_ = now;
  return phase_ == BusPhase::kOp;
}

bool Bus::Online(size_t number) const {
  return std::none_of(slaves_.begin(), slaves_.begin() + static_cast<std::ptrdiff_t>(number) + 1,
                      [](const SlaveState& slave) { return slave.lost; });
}

bool Bus::ready() const {
  if (phase_ != BusPhase::kOp) return false;
  return std::ranges::none_of(slaves_,
                              [](const SlaveState& slave) { return slave.lost || slave.silent; });
}

// --- Process data --------------------------------------------------------------------------------

std::optional<EntryPlace> Bus::PlaceOf(size_t number, ObjectId id, bool output) const {
  if (number >= places_.size()) return std::nullopt;
  const Slave& slave = (*configured_)[number];
  const ObjectEntry& entry = EntryOf(id);
  std::optional<EntryPlace> place =
      FindEntry(output ? slave.outputs : slave.inputs, entry.index, entry.subindex);
  const SlavePlace& data = places_[number];
  if (place) place->bit += 8 * (output ? data.outputs : data.inputs);
  return place;
}

std::optional<int64_t> Bus::Input(size_t number, ObjectId id) const {
  const std::optional<EntryPlace> place = PlaceOf(number, id, false);
  if (!place) return std::nullopt;
  return image_.Get(place->bit, place->bits, EntryOf(id).is_signed());
}

std::optional<int64_t> Bus::Output(size_t number, ObjectId id) const {
  const std::optional<EntryPlace> place = PlaceOf(number, id, true);
  if (!place) return std::nullopt;
  return image_.Get(place->bit, place->bits, EntryOf(id).is_signed());
}

bool Bus::HasOutput(size_t number, ObjectId id) const {
  return PlaceOf(number, id, true).has_value();
}

bool Bus::SetOutput(size_t number, ObjectId id, int64_t value) {
  const std::optional<EntryPlace> place = PlaceOf(number, id, true);
  if (!place) return false;
  image_.Put(place->bit, place->bits, value);
  return true;
}

void Bus::SendOutput(size_t number, ObjectId id, int64_t value) {
  const std::optional<EntryPlace> place = PlaceOf(number, id, true);
  if (place) image_.PutUnlessHeld(place->bit, place->bits, value);
}

void Bus::TakeOutputs() {
  for (size_t i = 0; i < slaves_.size() && phase_ == BusPhase::kOp; ++i) {
    if (!slaves_[i].drive || !Answers(i)) continue;
    ObjectValues& values = slaves_[i].drive->values();
    size_t bit = 8 * places_[i].outputs;
    for (const PdoEntry& entry : (*configured_)[i].outputs) {
      const std::optional<ObjectId> id = FindObject(entry.index, entry.subindex);
      if (id) values.Set(*id, image_.Get(bit, entry.bits, EntryOf(*id).is_signed()));
      bit += entry.bits;
    }
  }
  image_.EndExchange();
}

void Bus::GiveInputs() {
  for (size_t i = 0; i < slaves_.size() && phase_ >= BusPhase::kSafeOp; ++i) {
    if (!Answers(i)) continue;
    const SlaveState& slave = slaves_[i];
    size_t bit = 8 * places_[i].inputs;
    for (size_t byte = 0; byte < slave.inputs.size() && !slave.drive; ++byte) {
      image_.Put(bit + 8 * byte, 8, slave.inputs.bytes()[byte]);
    }
    for (const PdoEntry& entry : (*configured_)[i].inputs) {
      const std::optional<ObjectId> id = FindObject(entry.index, entry.subindex);
      if (id && slave.drive) image_.Put(bit, entry.bits, slave.drive->values()[*id]);
      bit += entry.bits;
    }
  }
}

void Bus::SetTerminal(size_t number, size_t item, int64_t value) {
  SlaveState& slave = slaves_[number];
  if (slave.drive) return slave.drive->values().Set(static_cast<ObjectId>(item), value);
  const std::vector<PdoEntry>& entries = (*connected_)[number].inputs;
  size_t bit = 0;
  for (size_t i = 0; i < item; ++i) bit += entries[i].bits;
  slave.inputs.Put(bit, entries[item].bits, value);
}

}  // namespace oncard::motion::bus
