// The card as a whole. Source: GT manual 2.2, 3.1 and chapter 11. Tested by
// tests/gtcalls/gt400/card_command_test.cc.
#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/gt400/events.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::gt400 {
namespace {

/// Assumption: 2.50, the first firmware with all commands of the public header.
constexpr double kVersion = 0x0250;

}  // namespace

int16_t GT_GetVrsn(Call& call) {
  call.Set(0, kVersion);
  return vm::kOk;
}

int16_t GT_SetSmplTm(Call& call) {
  const motion::MotionCore& core = call.card.motion;
  bool moves = core.PathRuns();
  for (size_t axis = 0; axis < core.axis_count(); ++axis) {
    moves = moves || Moves(call.card.view(), axis);
  }
  if (moves) {
    return RefuseFor(call, kInMotion,
                     {"an axis or a path is moving, the sample time can change at rest only",
                      "有轴或坐标系正在运动，仅可在静止时修改控制周期"});
  }
  StateOf(call).sample_time = call.value(0);
  if (call.card.set_cycle_ns) {
    call.card.set_cycle_ns(static_cast<int64_t>(motion::Whole(call.value(0) * kNsPerUs)));
  }
  return vm::kOk;
}

int16_t GT_GetSmplTm(Call& call) {
  call.Set(0, StateOf(call).sample_time);
  return vm::kOk;
}

int16_t GT_GetClock(Call& call) {
  const int64_t ticks = call.card.motion.part<&motion::MotionState::clock_cycle>();
  call.Set(0, static_cast<uint32_t>(ticks));
  return vm::kOk;
}

int16_t GT_GetCmdSts(Call& call) {
  call.Set(0, StateOf(call).command_register);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gt400
