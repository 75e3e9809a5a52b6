// Position/velocity/time motion: tables, their selection, loops, start.
// Source: GTS manual 7.7; the public header for parameters. Tested by
// tests/gtcalls/pvt_command_test.cc.
#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "gtcalls/gts/commands/motion_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::ContinuousRow;
using motion::ProfileMode;
using motion::PvtMode;
using motion::PvtTable;
using motion::PvtTablePointer;

/// Assumptions: limits of the arrays' elements; the manual gives one only for positions.
constexpr double kTimeMax = 2147483647;
constexpr double kVelocityMax = 32767;
constexpr double kElementAccelerationMin = kAboveZero;
constexpr double kElementAccelerationMax = 1e9;

int16_t CheckPvt(Call& call, size_t profile) { return CheckMode(call, profile, ProfileMode::kPvt); }

const PvtMode& PvtOf(const Call& call) { return ProfileOf(call).pvt; }
PvtMode& ChangePvt(const Call& call) { return ProfileAt(call).pvt(); }

const std::array<PvtTablePointer, motion::kPvtTableCount>& TablesOf(const Call& call) {
  return call.card.motion.part<&motion::MotionState::pvt_tables>();
}

// --- Ranges ----------------------------------------------------------------------------------

/// False, with the reason recorded, unless the value is in [minimum, maximum]; a NaN is not.
bool CheckValue(Call& call, size_t index, double minimum, double maximum) {
  const double value = call.value(index);
  if (value >= minimum && value <= maximum) return true;
  call.reason = MakeMessage("parameter {0} is {1}; the range is [{2}, {3}]",
                            "参数 {0} 为 {1}；取值范围为 [{2}, {3}]",
                            call.command.parameters[index].name, value, minimum, maximum);
  return false;
}

/// The same for the first `count` elements of an array.
bool CheckElements(Call& call, size_t index, size_t count, double minimum, double maximum) {
  const auto elements = call.cells(index).first(count);
  for (size_t i = 0; i < count; ++i) {
    if (elements[i] >= minimum && elements[i] <= maximum) continue;
    call.reason = MakeMessage(
        "{0}[{1}] is {2}; the range is [{3}, {4}]", "{0}[{1}] 为 {2}；取值范围为 [{3}, {4}]",
        call.command.parameters[index].name, i, elements[i], minimum, maximum);
    return false;
  }
  return true;
}

bool CheckVelocities(Call& call, size_t index, size_t count) {
  return CheckElements(call, index, count, -kVelocityMax, kVelocityMax);
}
bool CheckPositions(Call& call, size_t index, size_t count) {
  return CheckElements(call, index, count, -kPositionMax, kPositionMax);
}
bool CheckPercents(Call& call, size_t index, size_t count) {
  return CheckElements(call, index, count, 0, 100);
}

/// Checks that times are in range and increasing, and that positions are in range.
bool CheckPoints(Call& call, size_t times, size_t positions, size_t count) {
  if (!CheckElements(call, times, count, 0, kTimeMax)) return false;
  for (size_t i = 1; i < count; ++i) {
    const double before = call.cells(times)[i - 1];
    const double time = call.cells(times)[i];
    if (time - before >= motion::kPvtIntervalMin) continue;
    call.reason = MakeMessage(
        "pTime[{0}] is {1} ms, but the point before it is at {2} ms; times must increase by at "
        "least {3} ms",
        "pTime[{0}] 为 {1} ms，而前一点为 {2} ms；时间必须递增，至少相差 {3} ms", i, time, before,
        motion::kPvtIntervalMin);
    return false;
  }
  return CheckPositions(call, positions, count);
}

// --- Tables ----------------------------------------------------------------------------------

/// The number of points, from argument `index`.
size_t CountOf(const Call& call, size_t index) { return static_cast<size_t>(call.integer(index)); }

/// The first `count` elements of an array.
std::span<const double> Elements(const Call& call, size_t index, size_t count) {
  return call.cells(index).first(count);
}

/// Stores the table under the number in argument 0, unless it is too large. A motion in progress
/// keeps the table with which it started.
int16_t Fill(Call& call, PvtTable table) {
  if (table.slots() > size_t{kPvtPointMax}) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("the description takes {0} units of storage; a table has {1}",
                                   "该描述占用 {0} 个存储空间；每个数据表只有 {1} 个",
                                   table.slots(), kPvtPointMax));
  }
  call.card.motion.SetPvtTable(NumberOf(call), std::make_shared<const PvtTable>(std::move(table)));
  return vm::kOk;
}

int16_t FillFromVelocities(Call& call, size_t begin_velocities, size_t end_velocities) {
  const size_t count = CountOf(call, 1);
  if (!CheckPoints(call, 2, 3, count) || !CheckVelocities(call, begin_velocities, count) ||
      !CheckVelocities(call, end_velocities, count)) {
    return vm::kBadParameter;
  }
  return Fill(call, motion::PvtFromVelocities(Elements(call, 2, count), Elements(call, 3, count),
                                              Elements(call, begin_velocities, count),
                                              Elements(call, end_velocities, count)));
}

}  // namespace

int16_t GT_PvtTable(Call& call) { return FillFromVelocities(call, 4, 4); }

int16_t GT_PvtTableEx(Call& call) { return FillFromVelocities(call, 4, 5); }

int16_t GT_PvtTableComplete(Call& call) {
  const size_t count = CountOf(call, 1);
  if (!CheckPoints(call, 2, 3, count) || !CheckValue(call, 7, -kVelocityMax, kVelocityMax) ||
      !CheckValue(call, 8, -kVelocityMax, kVelocityMax)) {
    return vm::kBadParameter;
  }
  const auto times = Elements(call, 2, count);
  const auto positions = Elements(call, 3, count);
  const auto cubics = motion::SplineCoefficients(times, positions, call.value(7), call.value(8));
  const int16_t code = Fill(call, motion::PvtFromCubics(times, positions, cubics));
  for (size_t i = 0; i < count && code == vm::kOk; ++i) {
    call.Set(4, cubics[i].a, i);
    call.Set(5, cubics[i].b, i);
    call.Set(6, cubics[i].c, i);
  }
  return code;
}

int16_t GT_PvtTablePercent(Call& call) {
  const size_t count = CountOf(call, 1);
  if (!CheckPoints(call, 2, 3, count) || !CheckPercents(call, 4, count) ||
      !CheckValue(call, 5, -kVelocityMax, kVelocityMax)) {
    return vm::kBadParameter;
  }
  return Fill(call, motion::PvtFromPercents(Elements(call, 2, count), Elements(call, 3, count),
                                            Elements(call, 4, count), call.value(5)));
}

int16_t GT_PvtPercentCalculate(Call& call) {
  const size_t count = CountOf(call, 0);
  if (!CheckPoints(call, 1, 2, count) || !CheckPercents(call, 3, count) ||
      !CheckValue(call, 4, -kVelocityMax, kVelocityMax)) {
    return vm::kBadParameter;
  }
  const auto velocities =
      motion::PercentVelocities(Elements(call, 1, count), Elements(call, 2, count), call.value(4));
  for (size_t i = 0; i < count; ++i) call.Set(5, velocities[i], i);
  return vm::kOk;
}

namespace {

/// The rows of the six arrays from argument `first` on; empty, with the reason recorded, if no
/// motion is possible.
std::vector<ContinuousRow> ContinuousRows(Call& call, size_t first, size_t count) {
  if (!CheckPositions(call, first, count) || !CheckVelocities(call, first + 1, count)) return {};
  // No interval follows the last row, so only its position and velocity are used.
  const size_t used = count - 1;
  if (!CheckPercents(call, first + 2, used) ||
      !CheckElements(call, first + 3, used, 0, kVelocityMax) ||
      !CheckElements(call, first + 4, used, kElementAccelerationMin, kElementAccelerationMax) ||
      !CheckElements(call, first + 5, used, kElementAccelerationMin, kElementAccelerationMax)) {
    return {};
  }
  std::vector<ContinuousRow> rows(count);
  for (size_t i = 0; i < count; ++i) {
    const auto cell = [&](size_t column) { return call.cells(first + column)[i]; };
    rows[i] = {cell(0), cell(1), cell(2), cell(3), cell(4), cell(5)};
  }
  const size_t impossible = motion::FirstImpossibleInterval(rows);
  if (impossible == used) return rows;
  call.reason = MakeMessage(
      "the motion from point {0} to point {1} is not possible: the distance must not be 0, the "
      "velocities must have its direction and not exceed pVelMax, and it must be long enough for "
      "pAcc and pDec",
      "数据点 {0} 到 {1} 无法运动：位移不得为 0，速度须与位移同向且不超过 pVelMax，位移须满足 pAcc "
      "与 pDec",
      impossible, impossible + 1);
  return {};
}

}  // namespace

int16_t GT_PvtTableContinuous(Call& call) {
  const std::vector<ContinuousRow> rows = ContinuousRows(call, 2, CountOf(call, 1));
  if (rows.empty() || !CheckValue(call, 8, 0, kTimeMax)) return vm::kBadParameter;
  return Fill(call, motion::PvtFromLimits(rows, call.value(8)));
}

int16_t GT_PvtContinuousCalculate(Call& call) {
  const std::vector<ContinuousRow> rows = ContinuousRows(call, 1, CountOf(call, 0));
  if (rows.empty()) return vm::kBadParameter;
  const auto times = motion::ContinuousTimes(rows);
  for (size_t i = 0; i < times.size(); ++i) call.Set(7, times[i], i);
  return vm::kOk;
}

// --- Motion ----------------------------------------------------------------------------------

int16_t GT_PrfPvt(Call& call) { return ChooseMode(call, NumberOf(call), ProfileMode::kPvt); }

int16_t GT_SetPvtLoop(Call& call) {
  const int16_t code = CheckPvt(call, NumberOf(call));
  if (code == vm::kOk) ChangePvt(call).loop_target = call.integer(1);
  return code;
}

int16_t GT_GetPvtLoop(Call& call) {
  const int16_t code = CheckPvt(call, NumberOf(call));
  if (code != vm::kOk) return code;
  call.Set(1, PvtOf(call).loop_count);
  call.Set(2, PvtOf(call).loop_target);
  return vm::kOk;
}

namespace {

int16_t RefuseEmpty(Call& call, size_t table) {
  return call.Refuse(
      vm::kRefused,
      MakeMessage("PVT table {0} is empty, fill it first, with GT_PvtTable for "
                  "example",
                  "PVT 数据表 {0} 为空，请先写入数据，例如调用 GT_PvtTable", table + 1));
}

}  // namespace

int16_t GT_PvtTableSelect(Call& call) {
  const int16_t code = CheckPvt(call, NumberOf(call));
  if (code != vm::kOk) return code;
  const size_t table = NumberOf(call, 1);
  PvtMode& pvt = ChangePvt(call);
  if (pvt.running && TablesOf(call)[table] == nullptr) return RefuseEmpty(call, table);
  pvt.Select(static_cast<uint16_t>(table), TablesOf(call)[table]);
  return vm::kOk;
}

int16_t GT_PvtStart(Call& call) {
  const std::vector<size_t> profiles = SelectedProfiles(call);
  if (profiles.empty()) return vm::kRefused;
  for (const size_t i : profiles) {
    int16_t code = CheckModeAtRest(call, i, ProfileMode::kPvt);
    const size_t selected = call.card.motion.profile(i).pvt.selected;
    const motion::PvtTable* table = TablesOf(call)[selected].get();
    if (code == vm::kOk) {
      code = CheckMayStart(call, i, table == nullptr ? 0 : table->Direction());
    }
    if (code != vm::kOk) return code;
    if (table == nullptr) return RefuseEmpty(call, selected);
  }
  for (const size_t i : profiles) {
    const motion::ProfileHandle profile = call.card.motion.ProfileAt(i);
    PvtMode& pvt = profile.pvt();
    pvt.next = TablesOf(call)[pvt.selected];
    profile.Start();
  }
  return vm::kOk;
}

int16_t GT_PvtStatus(Call& call) {
  const size_t count = CountOf(call, 3);
  for (size_t i = 0; i < count; ++i) {
    const int16_t code = CheckPvt(call, NumberOf(call) + i);
    if (code != vm::kOk) return code;
  }
  for (size_t i = 0; i < count; ++i) {
    const PvtMode& pvt = call.card.motion.profile(NumberOf(call) + i).pvt;
    call.Set(1, (pvt.running ? pvt.current : pvt.selected) + 1, i);
    call.Set(2, pvt.time, i);
  }
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
