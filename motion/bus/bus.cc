#include "motion/bus/bus.h"

#include <algorithm>

namespace oncard::motion::bus {
namespace {

constexpr uint8_t kPositionBits = 32;

}  // namespace

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
  mapped_ = std::make_shared<const std::vector<MappedSlave>>(MapSlaves(*configured_));
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

const MappedObject* Bus::FindInput(size_t number, ObjectId id) const {
  if (mapped_ == nullptr || number >= mapped_->size()) return nullptr;
  return (*mapped_)[number].inputs.Find(id);
}

const MappedObject* Bus::FindOutput(size_t number, ObjectId id) const {
  if (mapped_ == nullptr || number >= mapped_->size()) return nullptr;
  return (*mapped_)[number].outputs.Find(id);
}

std::optional<int64_t> Bus::Input(size_t number, ObjectId id) const {
  const MappedObject* object = FindInput(number, id);
  return object == nullptr ? std::nullopt : std::optional(ValueOf(*object));
}

std::optional<int64_t> Bus::Output(size_t number, ObjectId id) const {
  const MappedObject* object = FindOutput(number, id);
  return object == nullptr ? std::nullopt : std::optional(ValueOf(*object));
}

bool Bus::HasOutput(size_t number, ObjectId id) const { return FindOutput(number, id) != nullptr; }

bool Bus::SetOutput(size_t number, ObjectId id, int64_t value) {
  const MappedObject* object = FindOutput(number, id);
  if (object == nullptr) return false;
  image_.Put(object->place.bit, object->place.bits, value);
  return true;
}

void Bus::SendOutput(size_t number, ObjectId id, int64_t value) {
  const MappedObject* object = FindOutput(number, id);
  if (object != nullptr) image_.PutUnlessHeld(object->place.bit, object->place.bits, value);
}

bool Bus::ExchangesOnlyPositions(size_t number) const {
  const MappedObject* measured = FindInput(number, ObjectId::kPositionActual);
  if (measured == nullptr || measured->place.bits != kPositionBits || image_.held()) return false;
  const ObjectValues& values = slaves_[number].drive->values();
  int targets = 0;
  for (const MappedObject& object : (*mapped_)[number].outputs.all()) {
    if (object.id != ObjectId::kTargetPosition) {
      if (values[object.id] != ValueOf(object)) return false;
    } else {
      if (object.place.bits != kPositionBits) return false;
      ++targets;
    }
  }
  return targets == 1;
}

void Bus::TakeOutputs() {
  for (size_t i = 0; i < slaves_.size() && phase_ == BusPhase::kOp; ++i) {
    if (!slaves_[i].drive || !Answers(i)) continue;
    ObjectValues& values = slaves_[i].drive->values();
    for (const MappedObject& object : (*mapped_)[i].outputs.all()) {
      values.Set(object.id, ValueOf(object));
    }
  }
  image_.EndExchange();
}

void Bus::GiveInputs() {
  for (size_t i = 0; i < slaves_.size() && phase_ >= BusPhase::kSafeOp; ++i) {
    if (!Answers(i)) continue;
    const SlaveState& slave = slaves_[i];
    const MappedSlave& data = (*mapped_)[i];
    if (!slave.drive) {
      for (size_t byte = 0; byte < slave.inputs.size(); ++byte) {
        image_.Put(8 * (data.place.inputs + byte), 8, slave.inputs.bytes()[byte]);
      }
      continue;
    }
    for (const MappedObject& object : data.inputs.all()) {
      image_.Put(object.place.bit, object.place.bits, slave.drive->values()[object.id]);
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
