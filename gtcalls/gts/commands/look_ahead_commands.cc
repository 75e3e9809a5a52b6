// The multi-axis look-ahead: set-up, settings, initialisation, flush, time of a virtual run.
// Source: manual of the multi-axis look-ahead module, chapter 2. Tested by
// tests/gtcalls/look_ahead_command_test.cc.
#include <algorithm>
#include <cmath>

#include "gtcalls/gts/commands/look_ahead_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::AxisLimits;
using motion::CrdFifo;
using motion::PathLimits;
using motion::PathPlanner;

// AXIS_LIMIT_...
constexpr int kLimitsVelocity = 1;
constexpr int kLimitsAcceleration = 2;
constexpr int kLimitsJump = 4;
constexpr int kLimitsAll = 7;

// EVelSettingDef.
constexpr int kNormalVelocity = 0;
constexpr int kNumVelocity = 1;
constexpr int kCutVelocity = 2;

// Cells of TLookAheadParameter.
constexpr size_t kWindowCell = 0;
constexpr size_t kTimeCell = 1;
constexpr size_t kRatioCell = 2;
constexpr size_t kVelocityCells = 3;
constexpr size_t kAccelerationCells = 11;
constexpr size_t kJumpCells = 19;
constexpr size_t kScaleCells = 27;
constexpr size_t kRelationCells = 35;

/// Times, ratios and scales are below this.
constexpr double kFactorBound = 1e9;

}  // namespace

// --- Set-up and settings -----------------------------------------------------------------------

int16_t GT_SetupLookAheadCrd(Call& call) {
  int16_t code = CheckNumbers(call);
  if (code == vm::kOk) code = CheckWhole(call, "machineMode", call.value(1), 0, 3);
  if (code != vm::kOk) return code;
  if (CheckCrd(call, NumberOf(call)) != vm::kOk) return kPlatformRefuses;
  for (const CrdFifo& fifo : CrdOf(call).fifos) {
    if (fifo.plans_axes() && !fifo.planner->ring.empty()) {
      return call.Refuse(kPlatformRefuses,
                         MakeMessage("the look-ahead still holds {0} commands: call GT_CrdDataEx "
                                     "with NULL until it gives 0, or GT_CrdClear",
                                     "前瞻缓冲区中还有 {0} 条指令：请以 NULL 调用 GT_CrdDataEx "
                                     "直到返回 0，或调用 GT_CrdClear",
                                     fifo.planner->ring.size()));
    }
  }
  LookAheadSetup& setup = SetupOf(call);
  setup = {};
  setup.established = true;
  setup.mode = static_cast<MachineMode>(call.integer(1));
  // The defaults of the modes: manual, chapter 2, GT_SetupLookAheadCrd.
  const bool three_axes = setup.mode == MachineMode::kThreeAxes;
  setup.axis_limits.fill(three_axes ? 0 : kLimitsAll);
  setup.geometric = setup.mode != MachineMode::kMultiAxes;
  CrdAt(call).DropPlanners();
  return vm::kOk;
}

int16_t GT_SetAxisLimitModeLa(Call& call) {
  int16_t code = CheckEstablished(call);
  for (const double mode : call.cells(1)) {
    if (code == vm::kOk) code = CheckWhole(call, "pAxisLimitMode", mode, 0, kLimitsAll);
  }
  if (code != vm::kOk) return code;
  for (size_t i = 0; i < kLookAheadAxes; ++i) {
    SetupOf(call).axis_limits[i] = static_cast<uint8_t>(call.cells(1)[i]);
  }
  return vm::kOk;
}

int16_t GT_SetWorkLimitModeLa(Call& call) {
  int16_t code = CheckEstablished(call);
  if (code == vm::kOk) code = CheckWhole(call, "workLimitMode", call.value(1), 0, 1);
  if (code == vm::kOk) SetupOf(call).geometric = call.value(1) != 0;
  return code;
}

int16_t GT_SetAxisVelValidModeLa(Call& call) {
  int16_t code = CheckEstablished(call);
  if (code == vm::kOk) code = CheckWhole(call, "velValidAxis", call.value(1), 1, 0xFF);
  if (code == vm::kOk) SetupOf(call).length_axes = BitWord(call.value(1));
  return code;
}

int16_t GT_SetVelDefineModeLa(Call& call) {
  int16_t code = CheckEstablished(call);
  if (code == vm::kOk) {
    code = CheckWhole(call, "velDefMode", call.value(1), kNormalVelocity, kCutVelocity);
  }
  if (code != vm::kOk) return code;
  const MachineMode mode = SetupOf(call).mode;
  const int definition = call.integer(1);
  if ((mode == MachineMode::kThreeAxes && definition == kNumVelocity) ||
      (mode == MachineMode::kMultiAxes && definition != kNormalVelocity)) {
    return call.Refuse(
        kLookAheadParameter,
        MakeMessage("velDefMode {0} does not exist in this machine mode: with three axes there are "
                    "NORMAL_DEF_VEL and CUT_DEF_VEL, with several NORMAL_DEF_VEL",
                    "该机床类型不支持速度定义模式 {0}：三轴模式支持 NORMAL_DEF_VEL 和 "
                    "CUT_DEF_VEL，多轴模式只支持 NORMAL_DEF_VEL",
                    definition));
  }
  // The modes that are left mean the same: the velocity along the path.
  return vm::kOk;
}

namespace {

/// 0, or 107 when a profile that shall follow is an axis of the coordinate system, or its limits
/// are out of range.
int16_t CheckFollowers(Call& call) {
  for (size_t i = 0; i < kLookAheadAxes; ++i) {
    int16_t code = CheckWhole(call, "pAxisLimitMode", call.cells(1)[i], 0, kLimitsAll);
    if (code != vm::kOk || call.cells(1)[i] == 0) {
      if (code != vm::kOk) return code;
      continue;
    }
    if (CrdOf(call).HasMember(i)) {
      return call.Refuse(
          kLookAheadParameter,
          MakeMessage("profile {0} belongs to coordinate system {1} and cannot "
                      "follow its segments",
                      "规划器 {0} 属于坐标系 {1}，不能设为跟随轴", i + 1, call.integer(0)));
    }
    code = CheckSize(call, "pVmax", call.cells(2)[i], kAboveZero, kFactorBound);
    if (code == vm::kOk) {
      code = CheckSize(call, "pAmax", call.cells(3)[i], kAboveZero, kFactorBound);
    }
    if (code == vm::kOk) {
      code = CheckSize(call, "pDVmax", call.cells(4)[i], kAboveZero, kFactorBound);
    }
    if (code != vm::kOk) return code;
  }
  return vm::kOk;
}

}  // namespace

int16_t GT_SetFollowAxisParaLa(Call& call) {
  int16_t code = CheckEstablished(call);
  if (code != vm::kOk) return code;
  if (SetupOf(call).mode != MachineMode::kThreeAxes) {
    return call.Refuse(kLookAheadParameter,
                       MakeMessage("axes can follow in the mode NORMAL_THREE_AXIS only",
                                   "只有三轴模式（NORMAL_THREE_AXIS）支持跟随轴"));
  }
  code = CheckFollowers(call);
  if (code != vm::kOk) return code;
  for (size_t i = 0; i < kLookAheadAxes; ++i) {
    SetupOf(call).followers[i] = {call.cells(1)[i] != 0, call.cells(2)[i], call.cells(3)[i],
                                  call.cells(4)[i]};
  }
  return vm::kOk;
}

// --- Initialisation ----------------------------------------------------------------------------

namespace {

/// 0, or 107 unless axisRelation gives each coordinate another axis of the planner, or none, and no
/// follower is one of the first two.
int16_t CheckRelation(Call& call) {
  const std::span<double> cells = call.cells(1);
  uint32_t seen = 0;
  for (size_t i = 0; i < kLookAheadAxes; ++i) {
    const double axis = cells[kRelationCells + i];
    const int16_t code = CheckWhole(call, "axisRelation", axis, 0, kLookAheadAxes);
    if (code != vm::kOk) return code;
    if (axis == 0) continue;
    const uint32_t bit = uint32_t{1} << static_cast<unsigned>(axis);
    if ((seen & bit) != 0) {
      return call.Refuse(kLookAheadParameter,
                         MakeMessage("axisRelation gives axis {0} to two coordinates",
                                     "axisRelation 将轴 {0} 分配给了两个坐标", axis));
    }
    seen |= bit;
    if (SetupOf(call).followers[i].follows && axis < 3) {
      return call.Refuse(kLookAheadParameter,
                         MakeMessage("axis {0} follows and cannot be axis {1} of the planner",
                                     "轴 {0} 为跟随轴，不能对应前瞻轴 {1}", i + 1, axis));
    }
  }
  if (seen != 0) return vm::kOk;
  return call.Refuse(kLookAheadParameter,
                     MakeMessage("axisRelation gives no coordinate an axis: usually it is 1 to 8",
                                 "axisRelation 未给任何坐标分配轴：一般设为 1 到 8"));
}

/// 0, or 107 unless the limits that apply to the planner's axis `axis` are positive.
int16_t CheckLimits(Call& call, size_t axis) {
  const int mode = SetupOf(call).axis_limits[axis];
  const std::span<double> cells = call.cells(1);
  int16_t code = vm::kOk;
  if ((mode & kLimitsVelocity) != 0) {
    code = CheckSize(call, "vMax", cells[kVelocityCells + axis], kAboveZero, kFactorBound);
  }
  if (code == vm::kOk && (mode & kLimitsAcceleration) != 0) {
    code = CheckSize(call, "aMax", cells[kAccelerationCells + axis], kAboveZero, kFactorBound);
  }
  if (code == vm::kOk && (mode & kLimitsJump) != 0) {
    code = CheckSize(call, "DVMax", cells[kJumpCells + axis], kAboveZero, kFactorBound);
  }
  return code;
}

int16_t CheckInitialisation(Call& call) {
  const std::span<double> cells = call.cells(1);
  int16_t code = CheckWhole(call, "lookAheadNum", cells[kWindowCell], 1, kWindowMax);
  if (code == vm::kOk) {
    code = CheckSize(call, "time", cells[kTimeCell], kAboveZero, kFactorBound);
  }
  if (code == vm::kOk) {
    code = CheckSize(call, "radiusRatio", cells[kRatioCell], kAboveZero, kFactorBound);
  }
  if (code == vm::kOk) {
    code = CheckSize(call, "scale", cells[kScaleCells], kAboveZero, kFactorBound);
  }
  if (code == vm::kOk) code = CheckRelation(call);
  for (size_t i = 0; i < CrdOf(call).dimension() && code == vm::kOk; ++i) {
    const double axis = cells[kRelationCells + i];
    if (axis > 0) code = CheckLimits(call, static_cast<size_t>(axis) - 1);
  }
  if (code == vm::kOk) code = CheckWhole(call, "motionMode", call.value(3), 0, 1);
  if (code != vm::kOk || call.value(3) == 0 || !call.given(4)) return code;
  for (size_t i = 0; i < CrdOf(call).dimension() && code == vm::kOk; ++i) {
    code = CheckSize(call, "Pos in pulses", call.cells(4)[i] * cells[kScaleCells], -kPositionMax,
                     kPositionMax + 1);
  }
  return code;
}

/// mm/s as pulse/ms, mm/s^2 as pulse/ms^2.
double VelocityIn(double mm_per_s, double scale) { return mm_per_s * scale / 1000; }
double AccelerationIn(double mm_per_s2, double scale) { return mm_per_s2 * scale / 1e6; }

/// The limits of a follower in pulses and ms.
AxisLimits LimitsOf(const FollowSettings& settings, double time, double scale) {
  return {VelocityIn(settings.velocity, scale), AccelerationIn(settings.acceleration, scale),
          VelocityIn(settings.jump * time, scale)};
}

/// The limits that TLookAheadParameter and the settings give, in pulses and ms.
PathLimits LimitsOf(const Call& call) {
  const std::span<double> cells = call.cells(1);
  const LookAheadSetup& setup = SetupOf(call);
  const double scale = cells[kScaleCells];
  const double time = cells[kTimeCell];
  PathLimits limits;
  limits.corner_time = time * 1000;
  limits.radius_ratio = cells[kRatioCell];
  limits.geometric = setup.geometric;
  limits.length_axes = 0;
  for (size_t i = 0; i < limits.axes.size(); ++i) {
    if (cells[kRelationCells + i] == 0) continue;
    const auto axis = static_cast<size_t>(cells[kRelationCells + i]) - 1;
    const bool counts = setup.mode != MachineMode::kThreeAxes || axis < 3;
    if (counts && (setup.length_axes >> axis & 1) != 0) limits.length_axes |= uint32_t{1} << i;
    // The others' have not been checked.
    if (i >= CrdOf(call).dimension()) continue;
    const int mode = setup.axis_limits[axis];
    AxisLimits& to = limits.axes[i];
    if ((mode & kLimitsVelocity) != 0)
      to.velocity = VelocityIn(cells[kVelocityCells + axis], scale);
    if ((mode & kLimitsAcceleration) != 0) {
      to.acceleration = AccelerationIn(cells[kAccelerationCells + axis], scale);
    }
    if ((mode & kLimitsJump) != 0) to.jump = VelocityIn(cells[kJumpCells + axis] * time, scale);
  }
  for (size_t i = 0; i < kLookAheadAxes; ++i) {
    if (setup.followers[i].follows) limits.followers[i] = LimitsOf(setup.followers[i], time, scale);
  }
  return limits;
}

/// Begins a planner for the command's buffer.
void BeginPlanner(const Call& call, const PathLimits& limits, double window) {
  CrdAt(call).BeginPlanner(FifoNumber(call), limits, static_cast<size_t>(window));
  BufferOf(call) = {};
}

/// 0, or 105 in a five-axis mode.
int16_t CheckLibrary(Call& call) {
  if (!SetupOf(call).five_axes()) return vm::kOk;
  return call.Refuse(kNoFiveAxisLibrary,
                     MakeMessage("the library for five-axis machines is missing: use "
                                 "NORMAL_THREE_AXIS or MULTI_AXES",
                                 "缺少五轴机床配置库：请使用 NORMAL_THREE_AXIS 或 MULTI_AXES"));
}

}  // namespace

int16_t GT_InitLookAheadEx(Call& call) {
  int16_t code = CheckEstablished(call);
  if (code == vm::kOk) code = CheckLibrary(call);
  if (code == vm::kOk) code = CheckInitialisation(call);
  if (code == vm::kOk) code = CheckDrained(call);
  if (code != vm::kOk) return code;
  BeginPlanner(call, LimitsOf(call), call.cells(1)[kWindowCell]);
  LookAheadBuffer& buffer = BufferOf(call);
  buffer.scale = call.cells(1)[kScaleCells];
  if (call.value(3) == 0) return vm::kOk;
  motion::Coordinates begin = FifoOf(call).tail;
  for (size_t i = 0; call.given(4) && i < CrdOf(call).dimension(); ++i) {
    begin[i] = call.cells(4)[i] * buffer.scale;
  }
  CrdAt(call).BeginVirtualRun(FifoNumber(call), begin);
  return vm::kOk;
}

int16_t GT_InitLookAheadPara(Call& call) {
  int16_t code = CheckNumbers(call);
  if (code == vm::kOk) code = CheckWhole(call, "lookAheadNum", call.value(1), 1, kWindowMax);
  if (code == vm::kOk) code = CheckSize(call, "time", call.value(2), kAboveZero, kFactorBound);
  if (code == vm::kOk) {
    code = CheckSize(call, "radiusRatio", call.value(3), kAboveZero, kFactorBound);
  }
  if (code == vm::kOk) {
    code = CheckSize(call, "scale", call.value(4), kAboveZero, kFactorBound);
  }
  if (code != vm::kOk) return code;
  if (CheckCrd(call, NumberOf(call)) != vm::kOk) return kNotEstablished;
  code = CheckLibrary(call);
  if (code == vm::kOk) code = CheckDrained(call);
  if (code != vm::kOk) return code;
  LookAheadSetup& setup = SetupOf(call);
  // The manual's example calls nothing else before.
  setup.established = true;
  PathLimits limits;
  limits.corner_time = call.value(2) * 1000;
  limits.radius_ratio = call.value(3);
  limits.geometric = setup.geometric;
  limits.length_axes = setup.length_axes & (setup.mode == MachineMode::kThreeAxes ? 0x7 : 0xF);
  for (size_t i = 0; i < kLookAheadAxes; ++i) {
    if (!setup.followers[i].follows) continue;
    limits.followers[i] = LimitsOf(setup.followers[i], call.value(2), call.value(4));
  }
  BeginPlanner(call, limits, call.value(1));
  BufferOf(call).in_pulses = true;
  BufferOf(call).scale = call.value(4);
  return vm::kOk;
}

// --- Flush and time ----------------------------------------------------------------------------

int16_t GT_CrdDataEx(Call& call) {
  int16_t code = CheckNumbers(call);
  if (code == vm::kOk && call.given(1)) {
    return call.Refuse(kLookAheadParameter,
                       MakeMessage("pCrdData must be NULL", "pCrdData 只能为 NULL"));
  }
  if (code == vm::kOk) code = CheckInitialised(call);
  if (code != vm::kOk) return code;
  if (CrdAt(call).Flush(FifoNumber(call))) {
    BufferOf(call).awaits_start = true;
    BufferOf(call).auxiliaries = 0;
    return vm::kOk;
  }
  return call.Refuse(vm::kRefused,
                     MakeMessage("FIFO {0} is full while the look-ahead still holds {1} commands: "
                                 "call GT_CrdDataEx with NULL again until it gives 0",
                                 "FIFO {0} 已满，前瞻缓冲区中还有 {1} 条指令：请再次以 NULL 调用 "
                                 "GT_CrdDataEx，直到返回 0",
                                 FifoNumber(call), FifoOf(call).Ahead().size()));
}

int16_t GT_GetMotionTimeEx(Call& call) {
  const int16_t code = CheckInitialised(call);
  if (code != vm::kOk) return code;
  if (!FifoOf(call).is_virtual()) {
    return call.Refuse(kLookAheadParameter,
                       MakeMessage("the buffer executes its segments: a time is computed after "
                                   "GT_InitLookAheadEx with motionMode 1",
                                   "该缓存区执行实际加工：只有以 motionMode 为 1 调用 "
                                   "GT_InitLookAheadEx 后才预估加工时间"));
  }
  call.Set(1, FifoOf(call).planner->virtual_run.time);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
