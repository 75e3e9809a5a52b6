// Homing: smart (GT_GoHome) and simple (GT_Home and related commands).
// Source: application notes on smart homing; public header and GE manual for the simple commands.
// Tested by tests/gtcalls/home_command_test.cc.
#include "gtcalls/gts/commands/bus_support.h"
#include "gtcalls/gts/commands/motion_support.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::HomeError;
using motion::HomeKind;
using motion::HomeParameters;
using motion::Homing;

/// Cells of THomePrm. The first of pad1 asks for a fast way to the origin, the second of pad2 for a
/// check of the start.
enum HomeCell : size_t {
  kMode,
  kMoveDir,
  kIndexDir,
  kEdge,
  kTriggerIndex,
  kFinalFast,
  kVelHigh = kFinalFast + 3,
  kVelLow,
  kAcc,
  kDec,
  kSmoothTime,
  kCheckStart = kSmoothTime + 2,
  kHomeOffset = kCheckStart + 2,
  kSearchHomeDistance,
  kSearchIndexDistance,
  kEscapeStep
};

const Homing& HomingOf(const Call& call) {
  return call.card.motion.part<&motion::MotionState::homing>()[NumberOf(call)];
}

/// A member of THomePrm that has a range.
struct Bound {
  HomeCell cell;
  std::string_view name;
  double minimum;
  double maximum;
};
constexpr double kDistanceMax = 2147483647;
constexpr Bound kBounds[] = {
    {kEdge, "edge", 0, 1},
    {kVelHigh, "velHigh", kAboveZero, 32767},
    {kVelLow, "velLow", kAboveZero, 32767},
    {kAcc, "acc", kAboveZero, 32767},
    {kDec, "dec", kAboveZero, 32767},
    {kSmoothTime, "smoothTime", 0, kSmoothTimeMax},
    {kSearchHomeDistance, "searchHomeDistance", 0, kDistanceMax},
    {kSearchIndexDistance, "searchIndexDistance", 0, kDistanceMax},
    {kEscapeStep, "escapeStep", 0, kDistanceMax},
};

int16_t RefuseMember(Call& call, std::string_view name, double value, double minimum,
                     double maximum) {
  return call.Refuse(vm::kBadParameter, MakeMessage("THomePrm.{0} is {1}; {2} to {3} is expected",
                                                    "THomePrm.{0} 为 {1}；应为 {2} 到 {3}", name,
                                                    value, minimum, maximum));
}

/// 0, or 7 if a member of THomePrm is out of range.
int16_t CheckMembers(Call& call, motion::HomeMode mode) {
  const std::span<double> cells = call.cells(1);
  for (const Bound& bound : kBounds) {
    const double value = cells[bound.cell];
    if (!(value >= bound.minimum && value <= bound.maximum)) {
      return RefuseMember(call, bound.name, value, bound.minimum, bound.maximum);
    }
  }
  const int axes = call.card.motion.config().axis_count;
  if (cells[kTriggerIndex] < 0 || cells[kTriggerIndex] > axes) {
    return RefuseMember(call, "triggerIndex", cells[kTriggerIndex], 0, axes);
  }
  const auto is_direction = [](double value) { return value == 1 || value == -1; };
  if (mode != motion::HomeMode::kIndex && !is_direction(cells[kMoveDir])) {
    return RefuseMember(call, "moveDir", cells[kMoveDir], -1, 1);
  }
  if (motion::SearchesIndex(mode) && !is_direction(cells[kIndexDir])) {
    return RefuseMember(call, "indexDir", cells[kIndexDir], -1, 1);
  }
  if ((cells[kCheckStart] == 1 || mode == motion::HomeMode::kLimit) && cells[kEscapeStep] == 0) {
    return RefuseMember(call, "escapeStep", 0, 1, kDistanceMax);
  }
  return vm::kOk;
}

/// Refuses; GT_GetHomeStatus then also reports the reason.
int16_t RefuseHoming(Call& call, HomeError error) {
  call.card.motion.HomingAt(NumberOf(call)).Refuse(error);
  const size_t axis = NumberOf(call) + 1;
  switch (error) {
    case HomeError::kNotTrap:
      return call.Refuse(vm::kRefused, MakeMessage("axis {0} is not in mode Trap, call GT_PrfTrap",
                                                   "轴 {0} 不在点位模式，请调用 GT_PrfTrap", axis));
    case HomeError::kDisabled:
      return call.Refuse(vm::kRefused, MakeMessage("axis {0} is disabled, call GT_AxisOn",
                                                   "轴 {0} 未使能，请调用 GT_AxisOn", axis));
    case HomeError::kAlarm:
      return call.Refuse(vm::kRefused, MakeMessage("axis {0} has an alarm latched, call GT_ClrSts",
                                                   "轴 {0} 报警已锁存，请调用 GT_ClrSts", axis));
    default:
      break;
  }
  return call.Refuse(
      vm::kBadParameter,
      MakeMessage("THomePrm.mode is {0}; 10, 11, 12, 13, 20, 22, 30, 40 or 41 is expected",
                  "THomePrm.mode 为 {0}；应为 10、11、12、13、20、22、30、40 或 41",
                  call.cells(1)[kMode]));
}

int16_t CheckReadyToHome(Call& call) {
  int16_t code = CheckNotHoming(call, NumberOf(call));
  if (code == vm::kOk) code = CheckNoGantrySlave(call, NumberOf(call));
  if (code == vm::kOk) code = CheckBusObeys(call, NumberOf(call));
  return code == vm::kOk ? CheckAtRest(call, NumberOf(call)) : code;
}

}  // namespace

int16_t GT_GoHome(Call& call) {
  const std::span<double> cells = call.cells(1);
  const auto mode = HomeModeOf(static_cast<int>(cells[kMode]));
  if (mode == motion::HomeMode::kNone) return RefuseHoming(call, HomeError::kMode);
  int16_t code = CheckMembers(call, mode);
  if (code == vm::kOk) code = CheckReadyToHome(call);
  if (code != vm::kOk) return code;
  const HomeError error = call.card.motion.CheckHoming(NumberOf(call), mode);
  if (error != HomeError::kNone) return RefuseHoming(call, error);
  HomeParameters p;
  p.mode = mode;
  p.move_direction = cells[kMoveDir] < 0 ? int8_t{-1} : int8_t{1};
  p.index_direction = cells[kIndexDir] < 0 ? int8_t{-1} : int8_t{1};
  p.rising = cells[kEdge] != 0;
  p.trigger_index = static_cast<int16_t>(cells[kTriggerIndex]);
  p.final_fast = cells[kFinalFast] == 1;
  p.high = cells[kVelHigh];
  p.low = cells[kVelLow];
  p.acc = cells[kAcc];
  p.dec = cells[kDec];
  p.smooth_time = static_cast<int16_t>(cells[kSmoothTime]);
  p.check_start = cells[kCheckStart] == 1;
  p.offset = static_cast<int32_t>(cells[kHomeOffset]);
  p.home_distance = static_cast<int32_t>(cells[kSearchHomeDistance]);
  p.index_distance = static_cast<int32_t>(cells[kSearchIndexDistance]);
  p.escape = static_cast<int32_t>(cells[kEscapeStep]);
  call.card.motion.HomingAt(NumberOf(call)).Begin(p);
  return vm::kOk;
}

int16_t GT_GetHomePrm(Call& call) {
  const HomeParameters& p = HomingOf(call).parameters;
  for (size_t i = 0; i < call.cells(1).size(); ++i) call.Set(1, 0, i);
  call.Set(1, HomeNumber(p.mode), kMode);
  call.Set(1, p.move_direction, kMoveDir);
  call.Set(1, p.index_direction, kIndexDir);
  call.Set(1, p.rising ? 1 : 0, kEdge);
  call.Set(1, p.trigger_index == 0 ? call.value(0) : p.trigger_index, kTriggerIndex);
  call.Set(1, p.final_fast ? 1 : 0, kFinalFast);
  call.Set(1, p.high, kVelHigh);
  call.Set(1, p.low, kVelLow);
  call.Set(1, p.acc, kAcc);
  call.Set(1, p.dec, kDec);
  call.Set(1, p.smooth_time, kSmoothTime);
  call.Set(1, p.check_start ? 1 : 0, kCheckStart);
  call.Set(1, p.offset, kHomeOffset);
  call.Set(1, p.home_distance, kSearchHomeDistance);
  call.Set(1, p.index_distance, kSearchIndexDistance);
  call.Set(1, p.escape, kEscapeStep);
  return vm::kOk;
}

int16_t GT_GetHomeStatus(Call& call) {
  const Homing& homing = HomingOf(call);
  const double status[] = {homing.running ? 1.0 : 0.0,
                           static_cast<double>(HomeNumber(homing.stage)),
                           static_cast<double>(HomeNumber(homing.error)),
                           0,
                           homing.captured,
                           homing.target};
  for (size_t i = 0; i < std::size(status); ++i) call.Set(1, status[i], i);
  return vm::kOk;
}

// --- Simple homing ---------------------------------------------------------------------------

int16_t GT_HomeInit(Call& call) {
  for (size_t i = 0; i < kAxisMax; ++i) call.card.motion.HomingAt(i).Prepare();
  return vm::kOk;
}

namespace {

int16_t CheckPrepared(Call& call) {
  if (HomingOf(call).prepared) return vm::kOk;
  return call.Refuse(vm::kRefused, {"simple homing is not prepared, call GT_HomeInit",
                                    "回零尚未初始化，请调用 GT_HomeInit"});
}

/// Searches for the home switch of an axis, at most up to the position in argument 1.
int16_t SearchSimply(Call& call, HomeKind kind, double velocity, double acceleration,
                     int32_t offset) {
  const auto in_range = [](double value) { return value >= kAboveZero && value <= 32767; };
  if (!in_range(velocity) || !in_range(acceleration)) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("vel is {0} and acc is {1}; the range of both is [1e-09, 32767]",
                                   "vel 为 {0}，acc 为 {1}；两者取值范围均为 [1e-09, 32767]",
                                   velocity, acceleration));
  }
  const size_t axis = NumberOf(call);
  int16_t code = CheckPrepared(call);
  if (code == vm::kOk) code = CheckMode(call, axis, motion::ProfileMode::kTrap);
  if (code == vm::kOk) code = CheckReadyToHome(call);
  if (code != vm::kOk) return code;
  if (!AxisOf(call).servo_on) {
    return call.Refuse(vm::kRefused, MakeMessage("axis {0} is not enabled, call GT_AxisOn",
                                                 "轴 {0} 未使能，请调用 GT_AxisOn", axis + 1));
  }
  call.card.motion.HomingAt(axis).BeginSimple(kind, call.integer(1), velocity, acceleration,
                                              offset);
  return vm::kOk;
}

}  // namespace

int16_t GT_Home(Call& call) {
  return SearchSimply(call, HomeKind::kHome, call.value(2), call.value(3), call.integer(4));
}

int16_t GT_HomeStop(Call& call) {
  return SearchSimply(call, HomeKind::kStop, call.value(2), call.value(3), 0);
}

/// Assumption: called before GT_Home, it adds a search for the index pulse after the home switch;
/// called after a GT_Home that has found its switch, it starts the search at once. The velocity is
/// half of GT_Home's.
int16_t GT_Index(Call& call) {
  const Homing& homing = HomingOf(call);
  const size_t axis = NumberOf(call);
  int16_t code = CheckPrepared(call);
  if (code == vm::kOk && !homing.running && homing.kind == HomeKind::kHome && homing.found) {
    code = CheckMode(call, axis, motion::ProfileMode::kTrap);
    if (code == vm::kOk) code = CheckReadyToHome(call);
  }
  if (code != vm::kOk) return code;
  call.card.motion.HomingAt(axis).SetIndexSearch(call.integer(1), call.integer(2));
  return vm::kOk;
}

namespace {

/// Assumption: the values that GT_HomeSts returns.
enum SimpleStatus : int { kSearching = 0, kFound = 1, kNotFound = 2 };

}  // namespace

int16_t GT_HomeSts(Call& call) {
  const Homing& homing = HomingOf(call);
  SimpleStatus status = kSearching;
  if (!homing.running && homing.found) status = kFound;
  if (!homing.running && !homing.found && homing.error != HomeError::kNone) status = kNotFound;
  call.Set(1, status);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
