#include "motion/bus/drive.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "motion/common/rounding.h"
#include "motion/io/analog.h"

namespace oncard::motion::bus {
namespace {

constexpr double kRatedTorque = 1000;

/// Bits of 60FDh.
constexpr uint32_t kInputMask = (1u << kSwitchCount) - 1;

std::optional<Sensor> SensorOf(DiType type) {
  switch (type) {
    case DiType::kLimitNegative:
      return Sensor::kNegativeLimit;
    case DiType::kLimitPositive:
      return Sensor::kPositiveLimit;
    case DiType::kHome:
      return Sensor::kHome;
    default:
      return std::nullopt;
  }
}

// Another member, which cycles may change: OnlyMoves() says what makes sure that they do not.
static_assert(kFieldCount<BusDrive> == 13);

bool IsTorqueMode(DriveMode mode) {
  return mode == DriveMode::kProfileTorque || mode == DriveMode::kCyclicTorque;
}

}  // namespace

bool IsSupportedMode(int64_t mode) {
  constexpr int64_t kModes[] = {0, 1, 3, 4, 6, 8, 9, 10};
  return std::ranges::find(kModes, mode) != std::end(kModes);
}

// --- State -------------------------------------------------------------------------------------

void BusDrive::PowerOn(double motor) {
  origin_ = motor;
  ramp_.Rest(motor);
}

void BusDrive::LoseBus() {
  if (state_ != DriveState::kNotReady) state_ = DriveState::kFault;
  homing_ = {};
}

void BusDrive::Disable() {
  state_ = DriveState::kNotReady;
  homing_ = {};
}

void BusDrive::AdvanceState(const DriveWorld& world) {
  const DriveState before = state_;
  const auto control = static_cast<uint16_t>(values_[ObjectId::kControlWord]);
  state_ = NextState(state_, control, control_before_);
  if (state_ == DriveState::kOperationEnabled && before != state_) {
    // A position that was commanded before does not count.
    ramp_.Rest(world.motor.position);
    values_.Set(ObjectId::kTargetPosition, CountsAt(ramp_.position));
    positioning_ = false;
  }
  if (state_ != DriveState::kOperationEnabled) homing_ = {};
}

void BusDrive::TakeMode(double motor) {
  const int64_t wanted = values_[ObjectId::kMode];
  if (!IsSupportedMode(wanted) || static_cast<DriveMode>(wanted) == mode_) return;
  mode_ = static_cast<DriveMode>(wanted);
  homing_ = {};
  homing_done_ = false;
  positioning_ = false;
  acknowledged_ = false;
  ramp_.position = motor;
  values_.Set(ObjectId::kTargetPosition, CountsAt(motor));
}

void BusDrive::Advance(const DriveWorld& world) {
  const double from = world.motor.position;
  const double velocity = world.motor.velocity;
  TakeMode(from);
  AdvanceState(world);
  TouchProbes::TakeFunction(values_);
  if (state_ == DriveState::kOperationEnabled) {
    MoveEnabled(world);
  } else if (state_ == DriveState::kQuickStopActive) {
    const bool rests = BrakeDown(ObjectId::kQuickStopDeceleration, world);
    // 605Ah: 0 does not brake, 5 and 6 stay in this state.
    const int64_t option = values_[ObjectId::kQuickStopOption];
    if (option == 0 || (rests && option < 5)) state_ = DriveState::kSwitchOnDisabled;
  } else {
    Idle(world);
  }
  Capture(from, world);
  homing_.Pass(PassagesOf(from, world), world.motor.position > from);
  Measure(from, velocity, world);
  control_before_ = static_cast<uint16_t>(values_[ObjectId::kControlWord]);
}

void BusDrive::AdvanceAlone(const DriveWorld& world) {
  const double from = world.motor.position;
  Idle(world);
  PassagesOf(from, world);
}

bool BusDrive::OnlyMoves(const DriveWorld& world) const {
  const int64_t wanted = values_[ObjectId::kMode];
  if (IsSupportedMode(wanted) && static_cast<DriveMode>(wanted) != mode_) return false;
  const auto control = static_cast<uint16_t>(values_[ObjectId::kControlWord]);
  if (NextState(state_, control, control_before_) != state_) return false;
  if (homing_.phase != HomingPhase::kIdle || !TouchProbes::HasTakenFunction(values_)) return false;
  if (OperatedAt(world) != operated_) return false;
  const Plant& motor = world.motor;
  switch (state_) {
    case DriveState::kOperationEnabled:
      if (mode_ != DriveMode::kCyclicPosition || motor.stalled) return false;
      return world.mechanics.kind == DriveKind::kIdeal || world.mechanics.unit != 0;
    case DriveState::kQuickStopActive:
      return false;
    default:
      return motor.hand == 0 && ramp_.position == motor.position;
  }
}

void BusDrive::Idle(const DriveWorld& world) {
  Plant& motor = world.motor;
  motor.velocity = motor.stalled ? 0 : motor.hand;
  motor.position += motor.velocity * world.cycle_ms();
  ramp_.Rest(motor.position);
}

// --- Modes -------------------------------------------------------------------------------------

bool BusDrive::commanded(uint16_t bit) const {
  return (values_[ObjectId::kControlWord] & bit) != 0;
}

double BusDrive::PerMs(ObjectId id) const { return static_cast<double>(values_[id]) / kPerSecond; }

double BusDrive::PerMs2(ObjectId id) const {
  return static_cast<double>(values_[id]) / kPerSecond / kPerSecond;
}

void BusDrive::MoveEnabled(const DriveWorld& world) {
  if (IsTorqueMode(mode_)) return AdvanceTorque(world);
  const Ramp before = ramp_;
  const bool halt = commanded(kControlHalt);
  switch (mode_) {
    case DriveMode::kCyclicPosition:
      AdvanceCyclicPosition(world);
      break;
    case DriveMode::kCyclicVelocity:
      ramp_.velocity = PerMs(ObjectId::kTargetVelocity);
      ramp_.position += ramp_.velocity * world.cycle_ms();
      break;
    case DriveMode::kProfileVelocity:
      RampTo(halt ? 0 : PerMs(ObjectId::kTargetVelocity), ObjectId::kProfileAcceleration, world);
      break;
    case DriveMode::kProfilePosition:
      AdvanceProfilePosition(world);
      break;
    case DriveMode::kHoming:
      AdvanceHoming(world);
      break;
    default:
      ramp_.Rest(ramp_.position);
  }
  Follow(before, world);
}

void BusDrive::AdvanceCyclicPosition(const DriveWorld& world) {
  // Positions of 32 bits wrap; the shorter way is meant.
  const double present = Whole(ramp_.position - origin_);
  const auto wrapped = static_cast<uint32_t>(static_cast<int64_t>(present));
  const auto target = static_cast<uint32_t>(values_[ObjectId::kTargetPosition]);
  const double begin = ramp_.position;
  ramp_.position = origin_ + Bounded(present + static_cast<int32_t>(target - wrapped));
  ramp_.velocity = (ramp_.position - begin) / world.cycle_ms();
}

CountRange BusDrive::SoftLimits() const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto smallest = static_cast<double>(values_[ObjectId::kSoftLimitMin]);
  const auto largest = static_cast<double>(values_[ObjectId::kSoftLimitMax]);
  return smallest < largest ? CountRange{smallest, largest} : CountRange{-kNone, kNone};
}

double BusDrive::Bounded(double counts) const {
  const CountRange range = SoftLimits();
  return std::clamp(counts, range.low, range.high);
}

void BusDrive::AdvanceProfilePosition(const DriveWorld& world) {
  const bool wanted = commanded(kControlNewSetPoint);
  if (wanted && !acknowledged_) {
    const double base = commanded(kControlRelative) ? set_point_ : origin_;
    const double target = base + static_cast<double>(values_[ObjectId::kTargetPosition]);
    set_point_ = origin_ + Bounded(target - origin_);
    positioning_ = true;
  }
  acknowledged_ = wanted;
  if (!positioning_) {
    set_point_ = ramp_.position;
    return ramp_.Rest(ramp_.position);
  }
  if (commanded(kControlHalt)) return RampTo(0, ObjectId::kProfileDeceleration, world);
  const double speed =
      std::min(PerMs(ObjectId::kProfileVelocity), PerMs(ObjectId::kMaxProfileVelocity));
  // A ramp with one acceleration: the smaller of both.
  const double acceleration =
      std::min(PerMs2(ObjectId::kProfileAcceleration), PerMs2(ObjectId::kProfileDeceleration));
  ramp_.TowardsPosition(set_point_, speed, acceleration, world.cycle_ms());
}

void BusDrive::RampTo(double velocity, ObjectId acceleration, const DriveWorld& world) {
  const double largest =
      std::min(PerMs(ObjectId::kMaxProfileVelocity), PerMs(ObjectId::kMaxMotorSpeed));
  ramp_.TowardsVelocity(std::clamp(velocity, -largest, largest), PerMs2(acceleration),
                        world.cycle_ms());
}

bool BusDrive::BrakeDown(ObjectId deceleration, const DriveWorld& world) {
  const Ramp before = ramp_;
  ramp_.TowardsVelocity(0, PerMs2(deceleration), world.cycle_ms());
  Follow(before, world);
  return ramp_.velocity == 0;
}

void BusDrive::AdvanceHoming(const DriveWorld& world) {
  const bool start = commanded(kControlStartHoming);
  const bool edge = start && (control_before_ & kControlStartHoming) == 0;
  const int64_t method = values_[ObjectId::kHomingMethod];
  if (edge) {
    homing_done_ = false;
    if (FindHomingMethod(method)) {
      homing_.Begin(static_cast<int8_t>(method), operated_, world.motor.position);
    } else {
      homing_ = {.phase = HomingPhase::kFailed};
    }
  }
  if (!start && homing_.running()) homing_ = {};
  if (!homing_.running() || commanded(kControlHalt)) {
    return RampTo(0, ObjectId::kHomingAcceleration, world);
  }
  const HomingSpeeds speeds{PerMs(ObjectId::kHomingSwitchSpeed), PerMs(ObjectId::kHomingIndexSpeed),
                            PerMs2(ObjectId::kHomingAcceleration)};
  const bool arrived = ramp_.velocity == 0 && ramp_.position == homing_.home;
  if (!homing_.Advance(ramp_, speeds, world.cycle_ms()) || !arrived) return;
  const Plant& motor = world.motor;
  const bool rests = std::fabs(motor.velocity) * world.cycle_ms() < 0.5;
  if (!rests || std::fabs(motor.position - homing_.home) > kHomingWindow) return;
  homing_.phase = HomingPhase::kDone;
  homing_done_ = true;
  origin_ = homing_.home - static_cast<double>(values_[ObjectId::kHomeOffset]);
}

void BusDrive::AdvanceTorque(const DriveWorld& world) {
  const double largest = static_cast<double>(values_[ObjectId::kMaxTorque]);
  const double torque =
      std::clamp(static_cast<double>(values_[ObjectId::kTargetTorque]), -largest, largest);
  motion::Drive mechanics = world.mechanics;
  mechanics.Prepare(static_cast<double>(world.servo_us) / kPerSecond);
  for (int64_t t = 0; t < world.cycle_us; t += world.servo_us) {
    world.motor.Advance(mechanics, torque / kRatedTorque * kDacFull,
                        static_cast<double>(world.servo_us) / kPerSecond);
  }
  ramp_ = {world.motor.position, world.motor.velocity};
}

double BusDrive::LoopGain(const motion::Drive& mechanics, double servo_ms) {
  return 1 / (kPositionLoopLags * std::max(mechanics.tau, servo_ms));
}

void BusDrive::Follow(const Ramp& before, const DriveWorld& world) {
  Plant& motor = world.motor;
  if (motor.stalled) {
    motor.velocity = 0;
    return;
  }
  if (world.mechanics.kind == DriveKind::kIdeal) {
    motor.position = ramp_.position;
    motor.velocity = ramp_.velocity;
    return;
  }
  const double servo_ms = static_cast<double>(world.servo_us) / kPerSecond;
  const double gain = LoopGain(world.mechanics, servo_ms);
  const auto steps = static_cast<int>(world.cycle_us / world.servo_us);
  const double advance = (ramp_.position - before.position) / steps;
  for (int i = 1; i <= steps; ++i) {
    const double error = before.position + i * advance - motor.position;
    const double speed = advance / servo_ms + gain * error;
    const double output = world.mechanics.unit == 0 ? 0 : speed / world.mechanics.unit;
    motor.Advance(world.mechanics, std::clamp(output, -kDacFull, kDacFull), servo_ms);
  }
}

// --- Measurement -------------------------------------------------------------------------------

int64_t BusDrive::CountsAt(double place) const {
  return static_cast<int64_t>(Whole(place - origin_));
}

std::array<bool, kSwitchCount> BusDrive::OperatedAt(const DriveWorld& world) {
  std::array<bool, kSwitchCount> operated = world.pins;
  for (const PositionSwitch& contact : world.switches) {
    const std::optional<Sensor> sensor = SensorOf(contact.type);
    if (contact.axis != world.axis || !sensor) continue;
    operated[static_cast<size_t>(*sensor)] =
        contact.connected && contact.Inside(world.motor.position);
  }
  return operated;
}

std::vector<Passage> BusDrive::PassagesOf(double from, const DriveWorld& world) {
  const double to = world.motor.position;
  std::vector<Passage> passages;
  std::array<bool, kSwitchCount> wired{};
  for (const PositionSwitch& contact : world.switches) {
    const std::optional<Sensor> sensor = SensorOf(contact.type);
    if (contact.axis != world.axis || !sensor) continue;
    const auto number = static_cast<size_t>(*sensor);
    wired[number] = true;
    const SwitchPassage passage =
        contact.connected ? PassSwitch(contact, from, to) : SwitchPassage{};
    if (passage.enters) passages.push_back({*sensor, passage.entry, true});
    if (passage.leaves) passages.push_back({*sensor, passage.exit, false});
    const bool operated = contact.connected && contact.Inside(to);
    if (!passage.enters && !passage.leaves && operated != operated_[number]) {
      passages.push_back({*sensor, to, operated});
    }
    operated_[number] = operated;
  }
  for (size_t i = 0; i < kSwitchCount; ++i) {
    if (wired[i] || world.pins[i] == operated_[i]) continue;
    operated_[i] = world.pins[i];
    passages.push_back({static_cast<Sensor>(i), from, operated_[i]});
  }
  if (homing_.phase == HomingPhase::kIdle) return passages;
  ForEachMark(world.marks, from, to, [&](double place) {
    passages.push_back({Sensor::kIndex, place, true});
    return true;
  });
  std::ranges::stable_sort(passages, [&](const Passage& a, const Passage& b) {
    return from < to ? a.place < b.place : a.place > b.place;
  });
  return passages;
}

void BusDrive::Capture(double from, const DriveWorld& world) {
  for (const ProbeEdge& edge : world.probe_edges) {
    const double place = from + edge.fraction * (world.motor.position - from);
    probes_.Edge(edge.probe, edge.level, CountsAt(place), values_);
  }
}

void BusDrive::Measure(double from, double velocity_before, const DriveWorld& world) {
  const Plant& motor = world.motor;
  using enum ObjectId;
  values_.Set(kPositionActual, CountsAt(motor.position));
  values_.Set(kPositionDemand, CountsAt(ramp_.position));
  values_.Set(kFollowingError, CountsAt(ramp_.position) - CountsAt(motor.position));
  const double moved = motor.position - from;
  values_.Set(kVelocityActual, static_cast<int64_t>(Whole(moved / world.cycle_ms() * kPerSecond)));
  MeasureTorque(velocity_before, world);
  uint32_t inputs = static_cast<uint32_t>(values_[kDigitalInputs]) & ~kInputMask;
  for (size_t i = 0; i < kSwitchCount; ++i) inputs |= (operated_[i] ? 1u : 0u) << i;
  values_.Set(kDigitalInputs, inputs);
  const auto error = static_cast<double>(std::llabs(values_[kFollowingError]));
  const bool exceeds =
      enabled() && !IsTorqueMode(mode_) && error > static_cast<double>(values_[kErrorWindow]);
  if (exceeds) state_ = DriveState::kFaultReactionActive;
  values_.Set(kModeDisplay, static_cast<int64_t>(mode_));
  values_.Set(kStatusWord, StatusWord() | (exceeds ? kStatusFollowingError : 0));
}

void BusDrive::MeasureTorque(double velocity_before, const DriveWorld& world) {
  using enum ObjectId;
  const motion::Drive& mechanics = world.mechanics;
  const double velocity = world.motor.velocity;
  const double acceleration = (velocity - velocity_before) / world.cycle_ms();
  double torque = 0;
  if (state_ == DriveState::kOperationEnabled && mechanics.gain > 0) {
    torque = (velocity + mechanics.tau * acceleration) / mechanics.gain * kRatedTorque;
    if (IsTorqueMode(mode_)) torque = static_cast<double>(values_[kTargetTorque]);
  }
  const auto largest = static_cast<double>(values_[kMaxTorque]);
  const auto limited = static_cast<int64_t>(Whole(std::clamp(torque, -largest, largest)));
  for (const ObjectId id : {kTorqueDemand, kTorqueActual, kCurrentActual}) values_.Set(id, limited);
}

uint16_t BusDrive::StatusWord() const {
  unsigned status = StatusOf(state_) | kStatusRemote;
  const bool limited = operated_[static_cast<size_t>(Sensor::kNegativeLimit)] ||
                       operated_[static_cast<size_t>(Sensor::kPositiveLimit)];
  if (limited) status |= kStatusInternalLimit;
  if (state_ != DriveState::kOperationEnabled) return static_cast<uint16_t>(status);
  const bool rests = ramp_.velocity == 0;
  switch (mode_) {
    case DriveMode::kHoming:
      if (rests && !homing_.running()) status |= kStatusTargetReached;
      if (homing_done_) status |= kStatusHomingAttained;
      if (homing_.phase == HomingPhase::kFailed) status |= kStatusHomingError;
      break;
    case DriveMode::kProfilePosition:
      if (rests && ramp_.position == set_point_) status |= kStatusTargetReached;
      if (acknowledged_) status |= kStatusSetPointAcknowledged;
      break;
    case DriveMode::kProfileVelocity:
      if (ramp_.velocity == PerMs(ObjectId::kTargetVelocity)) status |= kStatusTargetReached;
      break;
    case DriveMode::kCyclicPosition:
    case DriveMode::kCyclicVelocity:
    case DriveMode::kCyclicTorque:
      status |= kStatusFollowsTarget;
      break;
    default:
      break;
  }
  return static_cast<uint16_t>(status);
}

}  // namespace oncard::motion::bus
