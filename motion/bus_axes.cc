#include "motion/bus_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/common/rounding.h"
#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

using bus::DriveMode;
using bus::DriveState;
using bus::ObjectId;
using bus::SdoAbort;

static_assert(kFieldsComplete<BusAxis> && kFieldsComplete<bus::Slave>);

constexpr DiType kSwitchTypes[bus::kSwitchCount] = {DiType::kLimitNegative, DiType::kLimitPositive,
                                                    DiType::kHome};

/// The fields of BusAxis that GT_Reset keeps.
BusAxis AfterReset(const BusAxis& link) {
  BusAxis fresh;
  fresh.slave = link.slave;
  fresh.alarm = link.alarm;
  fresh.raw = link.raw;
  fresh.counts = link.counts;
  return fresh;
}

}  // namespace

void BusAxes::NumberAxes() {
  const bus::SlavesPointer& slaves = state_.bus->line.configured();
  for (size_t i = 0; slaves != nullptr && i < slaves->size(); ++i) {
    const int8_t axis = (*slaves)[i].axis;
    if (axis < 0 || static_cast<size_t>(axis) >= axis_count()) continue;
    link(static_cast<size_t>(axis)).slave = static_cast<int8_t>(i);
  }
}

std::optional<size_t> BusAxes::MotorOf(size_t number) const {
  const bus::Bus& line = state_.bus->line;
  const int8_t axis = (*line.connected())[number].axis;
  const bool moves =
      line.slave(number).drive.has_value() && axis >= 0 && static_cast<size_t>(axis) < axis_count();
  return moves ? std::optional(static_cast<size_t>(axis)) : std::nullopt;
}

void BusAxes::PowerOn() {
  bus::Bus& line = state_.bus->line;
  for (size_t i = 0; i < line.slave_count(); ++i) {
    const std::optional<size_t> motor = MotorOf(i);
    if (motor) line.slave(i).drive->PowerOn(state_.plants[*motor].position);
  }
}

void BusAxes::Reset() {
  for (BusAxis& each : state_.bus->axes) each = AfterReset(each);
}

// --- The cycle ----------------------------------------------------------------------------------

void BusAxes::Exchange() {
  bus::Bus& line = state_.bus->line;
  if (line.AdvancePhase(now())) {
    // The init commands of the drives: cyclic synchronous position.
    for (size_t i = 0; i < axis_count(); ++i) {
      if (link(i).on_bus()) SetMode(i, DriveMode::kCyclicPosition);
    }
  }
  const bool operational = line.phase() == bus::BusPhase::kOp;
  for (size_t i = 0; i < axis_count() && operational; ++i) {
    if (link(i).on_bus()) SendOutputs(i);
  }
  line.TakeOutputs();
  for (size_t i = 0; i < line.slave_count(); ++i) {
    if (MotorOf(i)) AdvanceDrive(i);
  }
  line.GiveInputs();
  for (size_t i = 0; i < axis_count(); ++i) {
    if (link(i).on_bus()) ReadFeedback(i);
  }
}

uint16_t BusAxes::StatusWordOf(size_t axis) const {
  const bus::Bus& line = state_.bus->line;
  if (line.phase() != bus::BusPhase::kOp || !line.Answers(SlaveOf(axis))) return 0;
  return static_cast<uint16_t>(line.Input(SlaveOf(axis), ObjectId::kStatusWord).value_or(0));
}

uint16_t BusAxes::ControlWordOf(size_t axis) const {
  const BusAxis& own = link(axis);
  const DriveState state = bus::StateOf(StatusWordOf(axis));
  if (state == DriveState::kFault) return own.resets_fault ? bus::kControlFaultReset : 0;
  if (!state_.bus->line.started()) return 0;
  if (!own.enable) return bus::kControlShutdown;
  switch (state) {
    case DriveState::kSwitchOnDisabled:
      return bus::kControlShutdown;
    case DriveState::kReadyToSwitchOn:
      return bus::kControlSwitchOn;
    case DriveState::kSwitchedOn:
      return bus::kControlEnable;
    case DriveState::kOperationEnabled:
      return own.homing == BusHoming::kRuns ? bus::kControlEnable | bus::kControlStartHoming
                                            : bus::kControlEnable;
    default:
      return 0;
  }
}

void BusAxes::SendOutputs(size_t axis) {
  bus::Bus& line = state_.bus->line;
  BusAxis& own = link(axis);
  line.SendOutput(SlaveOf(axis), ObjectId::kControlWord, ControlWordOf(axis));
  double target = own.counts;
  if (own.follows) target = Whole((readings_.CommandedPosition(axis) + own.lead) * own.unit());
  // Positions of 32 bits wrap.
  const auto counts = static_cast<uint32_t>(static_cast<int64_t>(target));
  if (readings_.BusMode(axis) == DriveMode::kCyclicPosition) {
    line.SendOutput(SlaveOf(axis), ObjectId::kTargetPosition, static_cast<int32_t>(counts));
  }
}

bus::DriveWorld BusAxes::WorldOf(size_t number) const {
  const size_t index = *MotorOf(number);
  bus::DriveWorld world{.motor = state_.plants[index],
                        .mechanics = state_.drives[index],
                        .marks = state_.index_marks[index],
                        .switches = state_.switches,
                        .axis = index,
                        .probe_edges = {},
                        .cycle_us = config_.cycle_us,
                        .servo_us = config_.servo_us};
  for (size_t i = 0; i < bus::kSwitchCount; ++i) {
    world.pins[i] = (state_.io.Pins(kSwitchTypes[i]) >> index & 1) != 0;
  }
  return world;
}

void BusAxes::AdvanceDrive(size_t number) {
  bus::Bus& line = state_.bus->line;
  const std::vector<bus::ProbeEdge> edges = ProbeEdgesOf(number);
  bus::DriveWorld world = WorldOf(number);
  world.probe_edges = edges;
  bus::BusDrive& drive = *line.slave(number).drive;
  if (line.phase() == bus::BusPhase::kOp && line.Answers(number)) {
    drive.Advance(world);
    return;
  }
  if (line.phase() == bus::BusPhase::kOp) drive.LoseBus();
  drive.AdvanceAlone(world);
}

std::vector<bus::ProbeEdge> BusAxes::ProbeEdgesOf(size_t number) const {
  std::vector<bus::ProbeEdge> edges;
  const WorldProgress& world = state_.world;
  if (world.events == nullptr) return edges;
  const Micros begin = now() - config_.cycle_us;
  for (auto i = static_cast<size_t>(world.next); i < world.events->size(); ++i) {
    const WorldEvent& event = (*world.events)[i];
    if (event.at > now()) break;
    if (event.kind != WorldEventKind::kBusProbe || event.item != number) continue;
    const double fraction =
        static_cast<double>(event.at - begin) / static_cast<double>(config_.cycle_us);
    edges.push_back({static_cast<uint8_t>(event.index), event.value != 0, fraction});
  }
  return edges;
}

void BusAxes::ReadFeedback(size_t axis) {
  const bus::Bus& line = state_.bus->line;
  if (line.phase() < bus::BusPhase::kSafeOp || !line.Answers(SlaveOf(axis))) return;
  const std::optional<int64_t> position = line.Input(SlaveOf(axis), ObjectId::kPositionActual);
  if (!position) return;
  BusAxis& own = link(axis);
  const auto raw = static_cast<int32_t>(*position);
  const auto moved =
      static_cast<int32_t>(static_cast<uint32_t>(raw) - static_cast<uint32_t>(own.raw));
  own.raw = raw;
  const double before = own.feedback();
  own.counts += moved;
  const uint16_t status = StatusWordOf(axis);
  const bool found = own.homing == BusHoming::kRuns && (status & bus::kStatusHomingAttained) != 0;
  if (!found) return;
  // The drive has set its position: this is no motion.
  Encoder& encoder = state_.encoders[axis];
  const double shift = Whole(own.feedback()) - Whole(before);
  encoder.position += shift;
  encoder.source += shift;
}

uint32_t BusAxes::Follow() {
  bus::Bus& line = state_.bus->line;
  const bool operational = line.phase() == bus::BusPhase::kOp;
  uint32_t stops = 0;
  for (size_t i = 0; i < axis_count(); ++i) {
    BusAxis& own = link(i);
    if (!own.on_bus()) continue;
    Axis& axis = state_.axes[i];
    const uint16_t status = StatusWordOf(i);
    const DriveState drive = bus::StateOf(status);
    const bool fault = drive == DriveState::kFault || drive == DriveState::kFaultReactionActive;
    own.alarm = operational && (fault || !line.Answers(SlaveOf(i)));
    if (own.resets_fault && !fault) {
      own.resets_fault = false;
      if ((readings_.ActiveCauses(axis) & kAlarmBit) == 0) axis.latched &= ~uint32_t{kAlarmBit};
    }
    const bool enabled = drive == DriveState::kOperationEnabled && own.enable;
    if (axis.servo_on && !enabled) stops |= uint32_t{1} << i;
    axis.servo_on = enabled;
    JudgeHoming(own, status);
    const bool follows = enabled && readings_.BusMode(i) == DriveMode::kCyclicPosition;
    if (follows && !own.follows) Align(i);
    own.follows = follows;
  }
  return stops;
}

void BusAxes::JudgeHoming(BusAxis& own, uint16_t status) {
  const bool judged = own.homing == BusHoming::kRuns;
  if (own.homing == BusHoming::kArmed) own.homing = BusHoming::kRuns;
  if (!judged) return;
  const bool rests = (status & bus::kStatusTargetReached) != 0;
  // The drive says so, or it is disabled or has a fault.
  const bool failed = (status & bus::kStatusHomingError) != 0;
  const bool succeeded = !failed && rests && (status & bus::kStatusHomingAttained) != 0;
  const bool ended = bus::StateOf(status) != DriveState::kOperationEnabled;
  if (!failed && !succeeded && !ended) return;
  own.homing_status = kHomingFinished | (succeeded ? kHomingSucceeded : kHomingFailed);
  own.homing = BusHoming::kNone;
}

void BusAxes::Align(size_t axis) {
  if (!readings_.AxisMoving(state_.axes[axis])) Origins(state_, config_).AlignWithEncoder(axis);
  link(axis).lead = link(axis).feedback() - readings_.CommandedPosition(axis);
}

bool BusAxes::OnlyMove() const {
  const bus::Bus& line = state_.bus->line;
  if (line.phase() != bus::BusPhase::kOp) return false;
  for (size_t i = 0; i < line.slave_count(); ++i) {
    const std::optional<size_t> motor = MotorOf(i);
    // A drive that moves the motor of an axis is that of the axis.
    if (motor && (!link(*motor).on_bus() || SlaveOf(*motor) != i)) return false;
  }
  for (size_t i = 0; i < axis_count(); ++i) {
    if (link(i).on_bus() && !OnlyMoves(i)) return false;
  }
  return true;
}

bool BusAxes::OnlyMoves(size_t axis) const {
  const bus::Bus& line = state_.bus->line;
  const BusAxis& own = link(axis);
  const size_t number = SlaveOf(axis);
  if (!line.Answers(number) || MotorOf(number) != axis) return false;
  if (own.resets_fault || own.homing != BusHoming::kNone) return false;
  const bus::BusDrive& drive = *line.slave(number).drive;
  if (!line.ExchangesOnlyPositions(number) || !drive.OnlyMoves(WorldOf(number))) return false;
  if (line.Output(number, ObjectId::kControlWord) != ControlWordOf(axis)) return false;
  // What Follow() concludes is already known.
  const DriveState state = bus::StateOf(StatusWordOf(axis));
  const bool enabled = state == DriveState::kOperationEnabled && own.enable;
  if (state != drive.state() || own.alarm != (state == DriveState::kFault)) return false;
  if (state_.axes[axis].servo_on != enabled || own.follows != enabled) return false;
  return own.counts == Whole(state_.plants[axis].position - drive.origin());
}

// --- Commands -----------------------------------------------------------------------------------

void BusAxes::Enable(size_t axis, bool on) {
  link(axis).enable = on;
  if (on) return;
  state_.axes[axis].servo_on = false;
  link(axis).follows = false;
  link(axis).homing = BusHoming::kNone;
}

void BusAxes::ResetFault(size_t axis) {
  if (bus::StateOf(StatusWordOf(axis)) == DriveState::kFault) link(axis).resets_fault = true;
}

void BusAxes::SetMode(size_t axis, DriveMode mode) {
  bus::Bus& line = state_.bus->line;
  const auto number = static_cast<int64_t>(mode);
  if (line.SetOutput(SlaveOf(axis), ObjectId::kMode, number)) return;
  line.slave(SlaveOf(axis)).drive->values().Set(ObjectId::kMode, number);
}

void BusAxes::SetScale(size_t axis, uint8_t exponent) {
  link(axis).scale = exponent;
  DriveTrain(state_, config_).Rebase(axis);
  link(axis).lead = link(axis).feedback() - readings_.CommandedPosition(axis);
}

SdoAbort BusAxes::PrepareHoming(size_t axis, const BusHomingParameters& parameters) {
  bus::Bus& line = state_.bus->line;
  const double unit = link(axis).unit();
  const double speed = unit * bus::kPerSecond;
  const std::array<std::pair<ObjectId, double>, 5> downloads = {{
      {ObjectId::kHomingMethod, parameters.method},
      {ObjectId::kHomingSwitchSpeed, parameters.search_speed * speed},
      {ObjectId::kHomingIndexSpeed, parameters.index_speed * speed},
      {ObjectId::kHomingAcceleration, parameters.acceleration * speed * bus::kPerSecond},
      {ObjectId::kHomeOffset, parameters.offset * unit},
  }};
  for (const auto& [id, value] : downloads) {
    const bus::ObjectEntry& entry = bus::EntryOf(id);
    const double fitting =
        std::clamp(value, static_cast<double>(entry.smallest), static_cast<double>(entry.largest));
    std::array<uint8_t, 4> bytes{};
    const std::span<uint8_t> data = std::span(bytes).first(entry.bytes());
    bus::WriteNumber(static_cast<int64_t>(Whole(fitting)), data);
    const SdoAbort abort = line.Download(SlaveOf(axis), entry.index, entry.subindex, data);
    if (abort != SdoAbort::kNone) return abort;
  }
  link(axis).homing_prepared = true;
  return SdoAbort::kNone;
}

void BusAxes::StartHoming(size_t axis) {
  link(axis).homing = BusHoming::kArmed;
  link(axis).homing_status = 0;
}

void BusAxes::StopHoming(size_t axis) {
  link(axis).homing = BusHoming::kNone;
  link(axis).homing_status = 0;
}

}  // namespace oncard::motion
