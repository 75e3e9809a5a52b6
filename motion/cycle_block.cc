#include "motion/cycle_block.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "motion/bus_axes.h"
#include "motion/lane_uses.h"

namespace oncard::motion {
namespace {

static_assert(kLaneUsesComplete<MotionState> && kLaneUsesComplete<Profile> &&
              kLaneUsesComplete<Sample> && kLaneUsesComplete<Axis> &&
              kLaneUsesComplete<AxisValue> && kLaneUsesComplete<Encoder> &&
              kLaneUsesComplete<Plant> && kLaneUsesComplete<Step> && kLaneUsesComplete<Control> &&
              kLaneUsesComplete<Dac> && kLaneUsesComplete<BusPart> && kLaneUsesComplete<BusAxis>);

constexpr double kNoBound = std::numeric_limits<double>::infinity();

int64_t Choice(bool chosen) { return chosen ? kChosen : 0; }

bool MapsOnly(uint32_t map, size_t axis) { return map == uint32_t{1} << axis; }

/// True if a number that names an axis, a controller ... names this one or none.
bool OwnOrNone(int8_t number, size_t axis) {
  return number < 0 || number == static_cast<int8_t>(axis);
}

/// The reciprocal of a power of two, by which a product is the quotient; 0 for other values.
double ExactReciprocal(double value) {
  int exponent = 0;
  return std::frexp(value, &exponent) == 0.5 ? 1 / value : 0;
}

}  // namespace

CycleBlock::CycleBlock(MotionState& state, const MotionConfig& config, LaneKernel run)
    : state_(state), config_(config), kernel_(run), readings_(state, config) {}

// --- Whether a card is plain -------------------------------------------------------------------

bool CycleBlock::CardIsPlain() const {
  if (state_.compensates || state_.gantry.on || state_.homing_runs) return false;
  if (state_.shapers || (state_.bus && !BusAxes(state_, config_).OnlyMove())) return false;
  if (state_.capture.armed() || state_.compare.active() || !state_.reached.empty()) return false;
  if (!state_.io.InputsSettled()) return false;
  return std::ranges::all_of(state_.adcs, &Adc::settled) && SwitchesRest() && AuxiliaryRests();
}

bool CycleBlock::AuxiliaryRests() const {
  if (!HasAuxiliary(config_)) return true;
  for (size_t i = kAuxiliaryFirst; i < kAuxiliaryFirst + kAuxiliaryCount; ++i) {
    if (state_.plants[i].hand != 0 || state_.encoder_faults[i].any()) return false;
    if (!state_.encoders[i].resting()) return false;
  }
  return true;
}

/// The pins have the levels of the switches.
bool CycleBlock::SwitchesRest() const {
  return std::ranges::all_of(state_.switches, [this](const PositionSwitch& contact) {
    const bool level = (state_.io.Pins(contact.type) >> contact.bit & 1) != 0;
    return state_.io.Driven(contact.type, contact.bit) &&
           contact.Level(state_.plants[contact.axis].position) == level;
  });
}

bool CycleBlock::AxisIsPlain(size_t index) const {
  const Axis& axis = state_.axes[index];
  if (config_.drive_limits[index].any()) return false;  // judged in each cycle
  if (!axis.active || axis.latched != 0 || readings_.ActiveCauses(axis) != 0) return false;
  if (!MapsOnly(axis.profile_map, index) || !MapsOnly(axis.encoder_map, index)) return false;
  if (axis.profile_scale.alpha != axis.profile_scale.beta) return false;
  if (axis.encoder_scale.alpha != axis.encoder_scale.beta) return false;
  if (!axis.profile.filter.window.empty() || !axis.encoder.filter.window.empty()) return false;
  const Control& control = state_.controls[index];
  if (!OwnOrNone(control.axis, index) || !OwnOrNone(state_.steps[index].axis, index)) return false;
  return !control.check.on && !state_.encoder_faults[index].any();
}

std::optional<LaneKind> CycleBlock::KindOf(size_t index) const {
  if (readings_.OnBus(index)) return BusKind(index);
  const Plant& plant = state_.plants[index];
  const bool on = state_.axes[index].servo_on;
  if (!OwnOrNone(plant.axis, index) || !OwnOrNone(plant.control, index)) return std::nullopt;
  if (plant.stalled || (!on && plant.hand != 0)) return std::nullopt;
  if (on && plant.control >= 0) return ServoKind(index);
  if (state_.drives[index].kind == DriveKind::kVelocity) return LaneKind::kVoltage;
  return LaneKind::kFollow;
}

std::optional<LaneKind> CycleBlock::ServoKind(size_t index) const {
  const Control& control = state_.controls[index];
  const PidSet& set = control.pid();
  if (control.axis < 0 || control.encoder != static_cast<int8_t>(index)) return std::nullopt;
  if (!state_.encoders[index].active || state_.dacs[index].limit < 0) return std::nullopt;
  if (set.integral_limit < 0 || set.derivative_limit < 0 || set.limit < 0) return std::nullopt;
  return state_.drives[index].kind == DriveKind::kVelocity ? LaneKind::kServo
                                                           : LaneKind::kServoIdeal;
}

std::optional<LaneKind> CycleBlock::BusKind(size_t index) const {
  const bus::BusDrive& drive = BusDriveOf(index);
  // The sum of origin and target must not be rounded by much.
  if (std::fabs(drive.origin()) > kLaneCountMax) return std::nullopt;
  if (std::fabs(drive.ramp().position - drive.origin()) > kLaneCountMax) return std::nullopt;
  const bool velocity = state_.drives[index].kind == DriveKind::kVelocity;
  // A drive that is off does not control its motor.
  return velocity && drive.enabled() ? LaneKind::kBusVelocity : LaneKind::kBusIdeal;
}

int64_t CycleBlock::CyclesBeforeEvent() const {
  const WorldProgress& world = state_.world;
  if (world.events == nullptr || static_cast<size_t>(world.next) >= world.events->size()) {
    return kNoEnd;
  }
  const Micros left = (*world.events)[static_cast<size_t>(world.next)].at - now();
  if (left <= 0) return 0;
  // An edge of a probe acts inside the cycle of its instant.
  if (state_.bus) return (left - 1) / config_.cycle_us;
  // Any other event acts at the begin of the first cycle that begins at its instant or later.
  return (left + config_.cycle_us - 1) / config_.cycle_us;
}

int64_t CycleBlock::CyclesInBand(const Axis& axis) const {
  if (!axis.band_set) return kNoEnd;
  if (!axis.in_band) return axis.in_position ? 0 : kNoEnd;
  const Micros left = axis.band_time - (now() - axis.in_band_since);
  if (axis.in_position) return left <= config_.cycle_us ? kNoEnd : 0;
  return left <= 0 ? 0 : (left - 1) / config_.cycle_us;
}

// --- Into lanes --------------------------------------------------------------------------------

bool CycleBlock::Enter(int64_t cycles) {
  if (loaded_) return true;
  if (wait_ > 0) {
    --wait_;
    return false;
  }
  if ((cycles >= kWorthwhile || FollowPlans()) && Load()) return true;
  Wait();
  return false;
}

void CycleBlock::Wait() {
  // What ends a block early often goes on in the next cycles.
  wait_ = next_wait_;
  next_wait_ = std::min(2 * next_wait_, kWaitMax);
}

void CycleBlock::Retry() {
  wait_ = 0;
  next_wait_ = kWorthwhile;
}

bool CycleBlock::Load() {
  if (!CardIsPlain()) return false;
  int64_t cycles = CyclesBeforeEvent();
  std::array<LaneKind, kAxisMax> kinds{};
  for (size_t i = 0; i < axis_count() && cycles > 0; ++i) {
    const std::optional<LaneKind> kind = KindOf(i);
    if (!kind || !AxisIsPlain(i)) return false;
    kinds[i] = *kind;
    cycles = std::min(cycles, CyclesInBand(state_.axes[i]));
  }
  if (cycles == 0) return false;
  AssignLanes(kinds);
  plans_ = FollowPlans();
  piece_ends_.fill(kNoEnd);
  for (size_t i = 0; i < axis_count(); ++i) {
    LoadAxis(i);
    LoadControl(i);
    LoadDrive(i);
    LoadEncoder(i);
    if (readings_.OnBus(i)) LoadBusDrive(i);
    LoadProfile(i);
    if (plans_) LoadPlan(i);
  }
  FindEndOfPieces();
  for (const PositionSwitch& contact : state_.switches) LoadSwitch(contact);
  LoadTiming();
  // Kinds of lanes that do not use a value leave it as it is in both states.
  lanes_.other() = lanes_.current();
  loaded_ = true;
  tick_next_ = false;
  loaded_at_ = state_.cycle;
  end_ = Ahead(cycles);
  return true;
}

bool CycleBlock::FollowPlans() const {
  if (readings_.PathRuns()) return false;
  return std::all_of(state_.profiles.begin(), state_.profiles.begin() + config_.axis_count,
                     [](const Profile& profile) {
                       return !profile.now.moving || profile.driven || FollowsPlan(profile);
                     });
}

bool CycleBlock::FollowsPlan(const Profile& profile) {
  return profile.FollowedMaster() == nullptr && profile.FollowedPlan().first != nullptr;
}

void CycleBlock::LoadTiming() {
  constants_.cycle_ms = static_cast<double>(config_.cycle_us) / 1000;
  constants_.per_cycle_ms = ExactReciprocal(constants_.cycle_ms);
  constants_.servo_ms = config_.ServoMs();
  constants_.per_servo_ms = ExactReciprocal(constants_.servo_ms);
  constants_.sub_steps = static_cast<int32_t>(config_.cycle_us / config_.servo_us);
  constants_.per_sub_steps = ExactReciprocal(constants_.sub_steps);
  constants_.integral_unit = kIntegralUnit;
}

void CycleBlock::AssignLanes(const std::array<LaneKind, kAxisMax>& kinds) {
  kind_of_ = kinds;
  // Unused lanes rest at 0.
  constants_ = {};
  lanes_.now = 0;
  lanes_.current() = {};
  size_t next = 0;
  for (size_t kind = 0; kind < kLaneKindCount; ++kind) {
    constants_.begin[kind] = next;
    for (const bool moving : {true, false}) {
      for (size_t i = 0; i < axis_count(); ++i) {
        if (static_cast<size_t>(kinds[i]) != kind) continue;
        if (state_.profiles[i].now.moving == moving) lane_of_[i] = next++;
      }
    }
    next = (next + kLaneGroup - 1) / kLaneGroup * kLaneGroup;
    ends_[kind] = next;
  }
  constants_.end = ends_;
  constants_.soft_positive.fill(kNoBound);
  constants_.soft_negative.fill(-kNoBound);
  constants_.feed_divisor.fill(1);
  constants_.motor_low.fill(-kNoBound);
  constants_.motor_high.fill(kNoBound);
  constants_.error_limit.fill(kNoBound);
  constants_.unit.fill(1);
}

void CycleBlock::LoadAxis(size_t index) {
  const Axis& axis = state_.axes[index];
  const size_t lane = lane_of_[index];
  constants_.offset[lane] = axis.profile.offset;
  constants_.compensation[lane] = state_.compensations[index].Amount();
  if (axis.soft_positive != kNoPositiveLimit) constants_.soft_positive[lane] = axis.soft_positive;
  if (axis.soft_negative != kNoNegativeLimit) constants_.soft_negative[lane] = axis.soft_negative;
  constants_.encoder_offset[lane] = axis.encoder.offset;
  constants_.band[lane] = axis.band_set ? axis.band : 0;
  constants_.in_band[lane] = Choice(axis.band_set && axis.in_band);
  const Control& control = state_.controls[index];
  if (control.active && control.axis >= 0 && axis.servo_on) {
    constants_.error_limit[lane] = static_cast<double>(control.error_limit);
  }
  lanes_.current().measured[lane] = axis.encoder.position;
}

void CycleBlock::LoadControl(size_t index) {
  const Control& control = state_.controls[index];
  const PidSet& set = control.pid();
  const Dac& dac = state_.dacs[index];
  const size_t lane = lane_of_[index];
  constants_.kp[lane] = set.kp;
  constants_.ki[lane] = set.ki;
  constants_.kd[lane] = set.kd;
  constants_.kvff[lane] = set.kvff;
  constants_.kaff[lane] = set.kaff;
  constants_.sum_limit[lane] = set.integral_limit;
  constants_.difference_limit[lane] = set.derivative_limit;
  constants_.output_limit[lane] = set.limit;
  const bool limited = set.kvff_acc_max > 0;
  constants_.filters_feed |= set.kvff_filter != 0 || limited;
  constants_.feed_filtered[lane] = Choice(set.kvff_filter != 0 || limited);
  constants_.feed_divisor[lane] = 1 << set.kvff_filter;
  constants_.feed_change_max[lane] = limited ? set.kvff_acc_max * config_.ServoMs() : kNoBound;
  constants_.bias[lane] = dac.bias;
  constants_.dac_limit[lane] = dac.limit;
  constants_.dac_active[lane] = Choice(dac.active);
  constants_.voltage[lane] = state_.axes[index].servo_on ? dac.Output() : 0;
  LaneValues& values = lanes_.current();
  values.reference[lane] = control.reference;
  values.sum[lane] = control.sum;
  values.error_before[lane] = control.error_before;
  values.feed[lane] = control.feed;
  values.output[lane] = dac.value;
}

void CycleBlock::LoadDrive(size_t index) {
  const Drive& drive = state_.drives[index];
  const Plant& plant = state_.plants[index];
  const Step& step = state_.steps[index];
  const size_t lane = lane_of_[index];
  constants_.unit[lane] = drive.unit;
  constants_.friction[lane] = drive.friction;
  constants_.decay[lane] = drive.decay;
  constants_.lag[lane] = drive.lag;
  constants_.lead[lane] = plant.lead;
  constants_.follows[lane] = Choice(plant.axis >= 0 && state_.axes[index].servo_on);
  constants_.stepping[lane] = Choice(step.active && step.axis >= 0);
  constants_.step_lead[lane] = step.lead;
  LaneValues& values = lanes_.current();
  values.motor[lane] = plant.position;
  values.motor_velocity[lane] = plant.velocity;
  values.step[lane] = step.position;
}

void CycleBlock::LoadEncoder(size_t index) {
  const Encoder& encoder = state_.encoders[index];
  const size_t lane = lane_of_[index];
  constants_.external[lane] = Choice(encoder.external);
  constants_.counting[lane] = Choice(encoder.active);
  const double direction = encoder.reversed == encoder.wired_reversed ? 1 : -1;
  constants_.direction[lane] = encoder.external ? direction : 0;
  constants_.slip[lane] = state_.encoder_faults[index].slip;
  LaneValues& values = lanes_.current();
  values.source[lane] = encoder.source;
  values.count[lane] = encoder.position;
  values.count_velocity[lane] = encoder.velocity;
  values.count_acceleration[lane] = encoder.acceleration;
}

void CycleBlock::LoadBusDrive(size_t index) {
  const bus::BusDrive& drive = BusDriveOf(index);
  const BusAxis& link = state_.bus->axes[index];
  const bus::CountRange limits = drive.SoftLimits();
  const size_t lane = lane_of_[index];
  constants_.follows[lane] = Choice(link.follows);
  constants_.origin[lane] = drive.origin();
  constants_.lead[lane] = link.lead;
  // A drive that is off has no target.
  constants_.counts_per_pulse[lane] = link.follows ? link.unit() : 0;
  constants_.target_low[lane] = link.follows ? std::max(limits.low, -kLaneCountMax) : 0;
  constants_.target_high[lane] = link.follows ? std::min(limits.high, kLaneCountMax) : 0;
  constants_.loop_gain[lane] = bus::BusDrive::LoopGain(state_.drives[index], config_.ServoMs());
  constants_.error_window[lane] = static_cast<double>(drive.values()[bus::ObjectId::kErrorWindow]);
  constants_.output_limit[lane] = kDacFull;
  constants_.direction[lane] = 1 / link.unit();
  lanes_.current().ramp[lane] = drive.ramp().position;
}

void CycleBlock::LoadSwitch(const PositionSwitch& contact) {
  if (!contact.connected || contact.axis >= axis_count()) return;
  const size_t lane = lane_of_[contact.axis];
  const double position = state_.plants[contact.axis].position;
  double& low = constants_.motor_low[lane];
  double& high = constants_.motor_high[lane];
  if (position < contact.first) {
    high = std::min(high, std::nextafter(contact.first, -kNoBound));
  } else if (position > contact.last) {
    low = std::max(low, std::nextafter(contact.last, kNoBound));
  } else {
    low = std::max(low, contact.first);
    high = std::min(high, contact.last);
  }
}

void CycleBlock::LoadProfile(size_t index) {
  const Sample& sample = state_.profiles[index].now;
  const size_t lane = lane_of_[index];
  LaneValues& values = lanes_.current();
  values.position[lane] = sample.position;
  values.velocity[lane] = sample.velocity;
  values.acceleration[lane] = sample.acceleration;
  values.moving[lane] = Choice(sample.moving);
}

void CycleBlock::LoadPlan(size_t index) {
  const Profile& profile = state_.profiles[index];
  const size_t lane = lane_of_[index];
  if (!profile.now.moving || profile.driven) {
    constants_.planned[lane] = 0;
    constants_.clock_us[lane] = 0;
    piece_ends_[index] = kNoEnd;
    return;
  }
  const auto [plan, begin] = profile.FollowedPlan();
  constants_.planned[lane] = kChosen;
  constants_.clock_us[lane] = static_cast<double>(config_.cycle_us);
  lanes_.current().elapsed_us[lane] = static_cast<double>(now() - begin);
  piece_ends_[index] = Ahead(LoadPiece(lane, *plan, begin));
}

int64_t CycleBlock::LoadPiece(size_t lane, const Plan& plan, Micros begin) {
  for (Lane& earlier : constants_.earlier) earlier[lane] = 0;
  double t = MsBetween(begin, now() + config_.cycle_us);
  if (t >= plan.duration) {
    if (plan.end_velocity == 0) return 0;
    constants_.earlier[0][lane] = plan.duration;
    constants_.earlier_count = std::max(constants_.earlier_count, size_t{1});
    constants_.piece_position[lane] = plan.end_position;
    constants_.piece_velocity[lane] = plan.end_velocity;
    constants_.piece_acceleration[lane] = 0;
    return kNoEnd;
  }
  size_t i = 0;
  for (; i + 1 < plan.count && t >= plan.pieces[i].duration; ++i) {
    constants_.earlier[i][lane] = plan.pieces[i].duration;
    t -= plan.pieces[i].duration;
  }
  constants_.earlier_count = std::max(constants_.earlier_count, i);
  const Piece& piece = plan.pieces[i];
  constants_.piece_position[lane] = piece.position;
  constants_.piece_velocity[lane] = piece.velocity;
  constants_.piece_acceleration[lane] = piece.acceleration;
  // A cycle is left over, so that rounding does not decide which piece an instant belongs to. The
  // next one has been decided as the plan itself does.
  const double cycle_ms = static_cast<double>(config_.cycle_us) / 1000;
  const double cycles = std::max(1.0, (piece.duration - t) / cycle_ms);
  return cycles < 9e18 ? static_cast<int64_t>(cycles) : kNoEnd;
}

void CycleBlock::FindEndOfPieces() { pieces_end_ = std::ranges::min(piece_ends_); }

void CycleBlock::LoadNextPieces() {
  for (size_t i = 0; i < axis_count(); ++i) {
    if (piece_ends_[i] <= state_.cycle) LoadPlan(i);
  }
  FindEndOfPieces();
}

// --- In lanes ----------------------------------------------------------------------------------

void CycleBlock::TakeProfiles() {
  for (size_t i = 0; i < axis_count(); ++i) LoadProfile(i);
}

void CycleBlock::TakeStart(size_t index) {
  const Profile& profile = state_.profiles[index];
  if (profile.now.moving && !profile.driven && !FollowsPlan(profile)) return Leave();
  LoadProfile(index);
  LoadPlan(index);
  FindEndOfPieces();
  constants_.end = ends_;
}

int64_t CycleBlock::CyclesAhead() {
  if (pieces_end_ <= state_.cycle) LoadNextPieces();
  return std::min(end_, pieces_end_) - state_.cycle;
}

int64_t CycleBlock::Run(int64_t cycles) {
  if (still()) return cycles;
  int64_t done = kernel_(constants_, lanes_, 1);
  if (done == 1) {
    shown_ = false;
    if (plans_) TrimStillGroups();
    if (still()) return cycles;
    if (cycles > 1) done += kernel_(constants_, lanes_, cycles - 1);
  }
  tick_next_ = done < cycles;
  return done;
}

void CycleBlock::TrimStillGroups() {
  for (size_t kind = 0; kind < kLaneKindCount; ++kind) {
    size_t& end = constants_.end[kind];
    while (end > constants_.begin[kind] && GroupIsStill(end - kLaneGroup)) end -= kLaneGroup;
  }
}

bool CycleBlock::GroupIsStill(size_t first) const {
  const LaneValues& a = lanes_.values[0];
  const LaneValues& b = lanes_.values[1];
  const auto same = [first](const Lane& x, const Lane& y) {
    for (size_t lane = first; lane < first + kLaneGroup; ++lane) {
      if (std::bit_cast<uint64_t>(x[lane]) != std::bit_cast<uint64_t>(y[lane])) return false;
    }
    return true;
  };
  return same(a.elapsed_us, b.elapsed_us) && same(a.position, b.position) &&
         same(a.velocity, b.velocity) && same(a.acceleration, b.acceleration) &&
         same(a.reference, b.reference) && same(a.sum, b.sum) &&
         same(a.error_before, b.error_before) && same(a.feed, b.feed) && same(a.output, b.output) &&
         same(a.motor, b.motor) && same(a.motor_velocity, b.motor_velocity) &&
         same(a.ramp, b.ramp) && same(a.step, b.step) && same(a.source, b.source) &&
         same(a.count, b.count) && same(a.count_velocity, b.count_velocity) &&
         same(a.count_acceleration, b.count_acceleration) && same(a.measured, b.measured);
}

// --- Out of lanes ------------------------------------------------------------------------------

void CycleBlock::Unload() {
  Show();
  loaded_ = false;
  if (state_.cycle - loaded_at_ >= kWorthwhile) {
    Retry();
  } else {
    Wait();
  }
}

void CycleBlock::ShowAll() {
  shown_ = true;
  for (size_t i = 0; i < axis_count(); ++i) {
    StoreProfile(i);
    StoreAxis(i);
    StoreEncoder(i);
    StoreDrive(i);
  }
  if (state_.bus) StoreBus();
}

void CycleBlock::ShowEncoders() {
  for (size_t i = 0; i < axis_count(); ++i) {
    StoreEncoder(i);
    StoreAxis(i);
  }
}

void CycleBlock::StoreProfile(size_t index) {
  const LaneValues& values = lanes_.current();
  const size_t lane = lane_of_[index];
  if (constants_.planned[lane] == 0) return;
  Sample& sample = state_.profiles[index].now;
  sample.position = values.position[lane];
  sample.velocity = values.velocity[lane];
  sample.acceleration = values.acceleration[lane];
}

void CycleBlock::StoreAxis(size_t index) {
  const LaneValues& values = lanes_.current();
  const size_t lane = lane_of_[index];
  AxisValue& planned = state_.axes[index].profile;
  planned.position = (0.0 + values.position[lane]) + planned.offset;
  planned.velocity = 0.0 + values.velocity[lane];
  planned.acceleration = 0.0 + values.acceleration[lane];
  AxisValue& measured = state_.axes[index].encoder;
  measured.position = values.measured[lane];
  measured.velocity = 0.0 + values.count_velocity[lane];
  measured.acceleration = 0.0 + values.count_acceleration[lane];
}

void CycleBlock::StoreEncoder(size_t index) {
  const LaneValues& values = lanes_.current();
  const size_t lane = lane_of_[index];
  Encoder& encoder = state_.encoders[index];
  encoder.source = values.source[lane];
  encoder.position = values.count[lane];
  encoder.velocity = values.count_velocity[lane];
  encoder.acceleration = values.count_acceleration[lane];
}

void CycleBlock::StoreDrive(size_t index) {
  const LaneValues& values = lanes_.current();
  const size_t lane = lane_of_[index];
  Plant& plant = state_.plants[index];
  plant.position = values.motor[lane];
  plant.velocity = values.motor_velocity[lane];
  state_.steps[index].position = values.step[lane];
  const LaneKind kind = kind_of_[index];
  if (kind != LaneKind::kServo && kind != LaneKind::kServoIdeal) return;
  Control& control = state_.controls[index];
  control.reference = values.reference[lane];
  control.sum = values.sum[lane];
  control.error_before = values.error_before[lane];
  control.feed = values.feed[lane];
  state_.dacs[index].value = values.output[lane];
}

void CycleBlock::StoreBus() {
  // A tick exchanges anew: only from where the drives are.
  const LaneValues& begin = tick_next_ ? lanes_.current() : lanes_.other();
  for (size_t i = 0; i < axis_count(); ++i) {
    if (!readings_.OnBus(i)) continue;
    Plant& plant = state_.plants[i];
    const size_t lane = lane_of_[i];
    plant.position = begin.motor[lane];
    plant.velocity = begin.motor_velocity[lane];
    BusDriveOf(i).ContinueFrom(begin.ramp[lane]);
  }
  if (!tick_next_) BusAxes(state_, config_).Exchange();
}

}  // namespace oncard::motion
