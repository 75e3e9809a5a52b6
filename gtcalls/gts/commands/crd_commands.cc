// Coordinate systems: set-up, start, status, overrides, look-ahead.
// Source: the public header; GTS manual table 10-2. Tested by tests/gtcalls/crd_command_test.cc.
#include <algorithm>
#include <cmath>
#include <utility>

#include "gtcalls/gts/commands/look_ahead_support.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::Crd;
using motion::CrdFifo;
using motion::CrdParameters;
using motion::ProfileMode;

// Cells of TCrdPrm.
constexpr size_t kProfileCell = 1;
constexpr size_t kVelocityCell = 9;
constexpr size_t kAccelerationCell = 10;
constexpr size_t kEvenTimeCell = 11;
constexpr size_t kOriginFlagCell = 12;
constexpr size_t kOriginCell = 13;
/// Elements of TCrdPrm.profile and originPos.
constexpr size_t kParameterAxes = 8;
static_assert(kParameterAxes == motion::kCrdProfileCount);

/// Assumption: how far the axes may be from the path's next point when it starts, pulses.
constexpr double kStartTolerance = 1e-3;

int16_t RefuseMember(Call& call, std::string_view name, double value, std::string_view range) {
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("{0} is {1}; the range is {2}", "{0} 为 {1}；取值范围为 {2}", name,
                                 value, range));
}

// --- Set-up ----------------------------------------------------------------------------------

/// 0, or 7 unless every coordinate has exactly one profile, which exists on the card.
int16_t CheckMembers(Call& call) {
  const std::span<double> cells = call.cells(1);
  const int dimension = static_cast<int>(cells[0]);
  uint32_t seen = 0;
  for (size_t i = 0; i < kParameterAxes; ++i) {
    const double coordinate = cells[kProfileCell + i];
    if (coordinate == 0) continue;
    const bool usable = coordinate >= 1 && coordinate <= dimension &&
                        coordinate == std::floor(coordinate) && i < call.card.motion.axis_count();
    const uint32_t bit = usable ? uint32_t{1} << static_cast<unsigned>(coordinate) : 0;
    if (bit == 0 || (seen & bit) != 0) {
      return call.Refuse(
          vm::kBadParameter,
          MakeMessage("profile[{0}] is {1}; each coordinate from 1 to the dimension {2} must be "
                      "given to one profile of the card, and 0 to all others",
                      "profile[{0}] 为 {1}；1 到维数 {2} 的每个坐标必须分配给本控制卡的一个规划器，"
                      "其余为 0",
                      i, coordinate, dimension));
    }
    seen |= bit;
  }
  if (seen == (uint32_t{2} << dimension) - 2) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("a coordinate of the {0} has no profile: set the members of "
                                 "profile[] to 1 to {0}",
                                 "共 {0} 个坐标，其中有坐标没有规划器：请将 profile[] 的成员设为 1 "
                                 "到 {0}",
                                 dimension));
}

int16_t CheckParameters(Call& call) {
  const std::span<double> cells = call.cells(1);
  const double dimension = cells[0];
  if (!(dimension >= 1 && dimension <= motion::kCrdDimensionMax)) {
    return RefuseMember(call, "dimension", dimension, "[1, 4]");
  }
  int16_t code = CheckMembers(call);
  if (code != vm::kOk) return code;
  for (const auto& [cell, name] :
       {std::pair{kVelocityCell, "synVelMax"}, std::pair{kAccelerationCell, "synAccMax"}}) {
    if (!(cells[cell] >= kAboveZero && cells[cell] < kRateBound)) {
      return RefuseMember(call, name, cells[cell], "[1e-09, 32767)");
    }
  }
  if (!(cells[kEvenTimeCell] >= 0 && cells[kEvenTimeCell] < kRateBound)) {
    return RefuseMember(call, "evenTime", cells[kEvenTimeCell], "[0, 32767)");
  }
  const double flag = cells[kOriginFlagCell];
  if (flag != 0 && flag != 1) return RefuseMember(call, "setOriginFlag", flag, "[0, 1]");
  for (size_t i = 0; i < kParameterAxes; ++i) {
    if (std::fabs(cells[kOriginCell + i]) > kPositionMax) {
      return RefuseMember(call, "originPos", cells[kOriginCell + i], "[-1073741823, 1073741823]");
    }
  }
  return vm::kOk;
}

int16_t CheckCrdAtRest(Call& call, size_t crd) {
  if (!call.card.motion.part<&motion::MotionState::crds>()[crd].run.running) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("coordinate system {0} is moving, call GT_Stop with bit {1} and "
                                 "wait until GT_CrdStatus gives run 0",
                                 "坐标系 {0} 正在运动，请以第 {1} 位调用 GT_Stop 并等待 "
                                 "GT_CrdStatus 的 run 为 0",
                                 crd + 1, kFirstCrdBit + crd));
}

CrdParameters ParametersOf(const Call& call) {
  const std::span<double> cells = call.cells(1);
  CrdParameters parameters;
  parameters.dimension = static_cast<int16_t>(cells[0]);
  for (size_t i = 0; i < kParameterAxes; ++i) {
    parameters.coordinates[i] = static_cast<int16_t>(cells[kProfileCell + i]);
    parameters.origin[i] = static_cast<int32_t>(cells[kOriginCell + i]);
  }
  parameters.velocity_max = cells[kVelocityCell];
  parameters.acceleration_max = cells[kAccelerationCell];
  parameters.even_time = static_cast<int16_t>(cells[kEvenTimeCell]);
  parameters.sets_origin = cells[kOriginFlagCell] != 0;
  return parameters;
}

}  // namespace

int16_t GT_SetCrdPrm(Call& call) {
  int16_t code = CheckParameters(call);
  if (code == vm::kOk) code = CheckCrdAtRest(call, NumberOf(call));
  if (code != vm::kOk) return code;
  const CrdParameters parameters = ParametersOf(call);
  const motion::MotionCore& core = call.card.motion;
  for (size_t i = 0; i < kParameterAxes; ++i) {
    if (!parameters.CoordinateOf(i)) continue;
    code = CheckAtRest(call, i);
    if (code != vm::kOk) return code;
    const size_t other = 1 - NumberOf(call);
    const auto& crds = core.part<&motion::MotionState::crds>();
    if (core.profile(i).mode == ProfileMode::kCrd && crds[other].HasMember(i)) {
      return call.Refuse(
          vm::kRefused,
          MakeMessage("profile {0} belongs to coordinate system {1}, call GT_PrfTrap to remove it",
                      "规划器 {0} 属于坐标系 {1}，请调用 GT_PrfTrap 将其移出", i + 1, other + 1));
    }
  }
  CrdAt(call).SetUp(parameters);
  return vm::kOk;
}

int16_t GT_GetCrdPrm(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk) return code;
  const CrdParameters& parameters = CrdOf(call).parameters;
  call.Set(1, parameters.dimension, 0);
  for (size_t i = 0; i < kParameterAxes; ++i) {
    call.Set(1, parameters.coordinates[i], kProfileCell + i);
    call.Set(1, parameters.origin[i], kOriginCell + i);
  }
  call.Set(1, parameters.velocity_max, kVelocityCell);
  call.Set(1, parameters.acceleration_max, kAccelerationCell);
  call.Set(1, parameters.even_time, kEvenTimeCell);
  call.Set(1, parameters.sets_origin ? 1 : 0, kOriginFlagCell);
  return vm::kOk;
}

int16_t GT_SetCrdStopDec(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk) return code;
  CrdAt(call).SetStopDecelerations(call.value(1), call.value(2));
  return vm::kOk;
}

int16_t GT_GetCrdStopDec(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk) return code;
  call.Set(1, CrdOf(call).smooth_stop);
  call.Set(2, CrdOf(call).abrupt_stop);
  return vm::kOk;
}

int16_t GT_SetCrdLmtStopMode(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code == vm::kOk) CrdAt(call).SetLimitStop(call.integer(1) != kAbruptStopType);
  return code;
}

int16_t GT_GetCrdLmtStopMode(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk) return code;
  call.Set(1, CrdOf(call).limit_stop.smooth ? kSmoothStopType : kAbruptStopType);
  return vm::kOk;
}

namespace {

/// The number of elements of argument 1 that belong to coordinates.
size_t CoordinateCells(const Call& call) {
  return std::min(call.cells(1).size(), CrdOf(call).dimension());
}

}  // namespace

int16_t GT_SetCrdSingleMaxVel(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk) return code;
  for (size_t i = 0; i < CoordinateCells(call); ++i) {
    const double velocity = call.cells(1)[i];
    if (!(velocity >= kAboveZero && velocity <= Crd::kNoVelocityLimit)) {
      return RefuseMember(call, "pMaxVel", velocity, "[1e-09, 32767]");
    }
  }
  for (size_t i = 0; i < CoordinateCells(call); ++i) {
    CrdAt(call).SetVelocityMax(i, call.cells(1)[i]);
  }
  return vm::kOk;
}

namespace {

/// Writes one value per coordinate to argument 1.
int16_t GiveCoordinates(Call& call, const motion::Coordinates& values) {
  for (size_t i = 0; i < CoordinateCells(call); ++i) call.Set(1, values[i], i);
  return vm::kOk;
}

}  // namespace

int16_t GT_GetCrdSingleMaxVel(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  return code != vm::kOk ? code : GiveCoordinates(call, CrdOf(call).axis_velocity_max);
}

// --- Run -------------------------------------------------------------------------------------

namespace {

/// 0, or 1 with the reason if the axis of an interrupted modal GT_BufMove cannot continue.
int16_t CheckAwaitedMove(Call& call, const CrdFifo& fifo) {
  if (!fifo.awaits_move) return vm::kOk;
  const auto profile = static_cast<size_t>(fifo.move.item);
  const motion::Profile& awaited = call.card.motion.profile(profile);
  const int16_t code = CheckMode(call, profile, ProfileMode::kTrap);
  return code != vm::kOk ? code
                         : CheckMayStart(call, profile, fifo.move.values[0] - awaited.now.position);
}

/// 0, or the refusal to start FIFO `number`: it is empty, or axes are at another position or not
/// free.
int16_t CheckStart(Call& call, size_t index, size_t number) {
  int16_t code = CheckCrd(call, index);
  if (code == vm::kOk) code = CheckCrdAtRest(call, index);
  if (code != vm::kOk) return code;
  const Crd& crd = call.card.motion.part<&motion::MotionState::crds>()[index];
  const CrdFifo& fifo = crd.fifos[number];
  if (!fifo.executing && !fifo.awaits_move && fifo.slots.empty()) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("FIFO {0} of coordinate system {1} is empty: append segments, "
                                   "and with look-ahead call GT_CrdData with NULL",
                                   "坐标系 {1} 的 FIFO {0} 为空：请先写入插补段；使用前瞻时请以 "
                                   "NULL 调用 GT_CrdData",
                                   number, index + 1));
  }
  code = CheckAwaitedMove(call, fifo);
  if (code != vm::kOk) return code;
  const motion::PathSlot* first = fifo.executing ? &fifo.current : nullptr;
  for (size_t i = 0; first == nullptr && i < fifo.slots.size(); ++i) {
    if (fifo.slots.At(i).is_segment) first = &fifo.slots.At(i);
  }
  // The segments of a planner can follow commands without motion while these run.
  if (first == nullptr && fifo.planner && !fifo.is_virtual() && !fifo.planner->spans.empty()) {
    first = &fifo.planner->SlotOf(fifo.planner->spans.front());
  }
  if (first == nullptr) return vm::kOk;
  const double path = fifo.executing ? fifo.path : 0;
  const motion::Coordinates start = path > 0 ? first->segment.PointAt(path) : first->segment.start;
  const motion::Coordinates direction = first->segment.TangentAt(path);
  const motion::Coordinates position = call.card.motion.CrdPosition(index);
  for (size_t i = 0; i < crd.dimension(); ++i) {
    const auto profile = static_cast<size_t>(crd.members[i]);
    code = CheckModeAtRest(call, profile, ProfileMode::kCrd);
    if (code == vm::kOk) code = CheckMayStart(call, profile, direction[i]);
    if (code != vm::kOk) return code;
    if (std::fabs(position[i] - start[i]) > kStartTolerance) {
      return call.Refuse(vm::kRefused,
                         MakeMessage("coordinate {0} is at {1}, the path goes on at {2}: move the "
                                     "axes back, or call GT_CrdClear",
                                     "坐标 {0} 位于 {1}，轨迹应从 {2} "
                                     "继续：请将各轴移回，或调用 GT_CrdClear",
                                     i + 1, position[i], start[i]));
    }
  }
  return vm::kOk;
}

/// The coordinate systems that argument 0 selects; empty, with the reason recorded, if there are
/// none.
std::vector<size_t> SelectedCrds(Call& call) {
  std::vector<size_t> selected = CrdsOf(BitWord(call.value(0)));
  if (selected.empty()) {
    call.reason = MakeMessage("the mask selects no coordinate system; bit 0 is coordinate system 1",
                              "掩码未选中任何坐标系；第 0 位对应坐标系 1");
  }
  return selected;
}

int16_t StartEach(Call& call, bool single_step) {
  const std::vector<size_t> selected = SelectedCrds(call);
  if (selected.empty()) return vm::kRefused;
  const uint32_t fifos = BitWord(call.value(1));
  for (const size_t i : selected) {
    const int16_t code = CheckStart(call, i, fifos >> i & 1);
    if (code != vm::kOk) return code;
  }
  for (const size_t i : selected) call.card.motion.CrdAt(i).Start(fifos >> i & 1, single_step);
  return vm::kOk;
}

}  // namespace

int16_t GT_CrdStart(Call& call) { return StartEach(call, false); }
int16_t GT_CrdStartStep(Call& call) { return StartEach(call, true); }

int16_t GT_CrdStepMode(Call& call) {
  const std::vector<size_t> selected = SelectedCrds(call);
  if (selected.empty()) return vm::kRefused;
  for (const size_t i : selected) {
    const int16_t code = CheckCrd(call, i);
    if (code != vm::kOk) return code;
  }
  for (const size_t i : selected) {
    call.card.motion.CrdAt(i).SetStepMode((BitWord(call.value(1)) >> i & 1) != 0);
  }
  return vm::kOk;
}

int16_t GT_SetOverride(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code == vm::kOk) CrdAt(call).SetOverride(call.value(1));
  return code;
}

int16_t GT_SetOverride2(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code == vm::kOk) CrdAt(call).SetSecondOverride(call.value(1));
  return code;
}

int16_t GT_CrdClear(Call& call) {
  int16_t code = CheckCrd(call, NumberOf(call));
  if (code == vm::kOk && CrdOf(call).run.fifo == FifoNumber(call)) {
    code = CheckCrdAtRest(call, NumberOf(call));
  }
  if (code != vm::kOk) return code;
  CrdAt(call).Clear(FifoNumber(call));
  // The look-ahead of the buffer is empty as well, and begins where the axes are.
  BufferOf(call).auxiliaries = 0;
  BufferOf(call).has_start = false;
  return vm::kOk;
}

// --- Status ----------------------------------------------------------------------------------

namespace {

bool IsRunning(const Call& call) {
  return CrdOf(call).run.running && CrdOf(call).run.fifo == FifoNumber(call);
}

}  // namespace

int16_t GT_CrdStatus(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk) return code;
  call.Set(1, IsRunning(call) ? 1 : 0);
  call.Set(2, FifoOf(call).done);
  return vm::kOk;
}

namespace {

/// Commands that read one number of a coordinate system into argument 1.
template <typename Value>
int16_t Give(Call& call, Value value) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code == vm::kOk) call.Set(1, static_cast<double>(value()));
  return code;
}

}  // namespace

int16_t GT_CrdSpace(Call& call) {
  return Give(call, [&] { return FifoOf(call).space(); });
}

int16_t GT_GetCrdVel(Call& call) {
  return Give(call, [&] { return CrdOf(call).run.velocity; });
}

int16_t GT_GetLookAheadSpace(Call& call) {
  return Give(call, [&] {
    const CrdFifo& fifo = FifoOf(call);
    return fifo.planner ? fifo.planner->capacity - fifo.planner->Held() : 0;
  });
}

int16_t GT_GetLookAheadSegCount(Call& call) {
  return Give(call, [&] {
    const CrdFifo& fifo = FifoOf(call);
    return fifo.planner ? fifo.planner->Held() : 0;
  });
}

int16_t GT_GetUserSegNum(Call& call) {
  return Give(call, [&] { return FifoOf(call).current.user_number; });
}

int16_t GT_GetUserSegNumWN(Call& call) {
  return Give(call, [&] { return FifoOf(call).current.given_number; });
}

int16_t GT_GetRemainderSegNum(Call& call) {
  return Give(call, [&] { return FifoOf(call).Remaining(); });
}

int16_t GT_GetUserTargetVel(Call& call) {
  return Give(call, [&] { return CrdOf(call).active().current.velocity; });
}

int16_t GT_SetUserSegNum(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code == vm::kOk) CrdAt(call).SetUserNumber(FifoNumber(call), call.integer(1));
  return code;
}

int16_t GT_GetCrdPos(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  return code != vm::kOk ? code
                         : GiveCoordinates(call, call.card.motion.CrdPosition(NumberOf(call)));
}

int16_t GT_GetSegTargetPos(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  return code != vm::kOk ? code : GiveCoordinates(call, CrdOf(call).active().current.segment.end);
}

// --- Look-ahead ------------------------------------------------------------------------------

int16_t GT_InitLookAhead(Call& call) {
  const double time = call.value(2);
  const double acceleration = call.value(3);
  if (!(time >= kAboveZero && time < kRateBound)) {
    return RefuseMember(call, "T", time, "[1e-09, 32767)");
  }
  if (!(acceleration >= kAboveZero && acceleration < kRateBound)) {
    return RefuseMember(call, "accMax", acceleration, "[1e-09, 32767)");
  }
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk) return code;
  if (!FifoOf(call).Ahead().empty()) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("the look-ahead buffer holds {0} segments, call GT_CrdData with "
                                   "NULL or GT_CrdClear first",
                                   "前瞻缓冲区中还有 {0} 段，请先以 NULL 调用 GT_CrdData 或调用 "
                                   "GT_CrdClear",
                                   FifoOf(call).Ahead().size()));
  }
  CrdAt(call).BeginLookAhead(FifoNumber(call), time, acceleration,
                             static_cast<size_t>(call.integer(4)));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
