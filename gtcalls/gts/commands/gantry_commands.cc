// Gantries. Source: the public header names the commands; what they do is assumption.
// Tested by tests/gtcalls/gantry_command_test.cc.
#include "gtcalls/gts/commands/motion_support.h"

namespace oncard::gtcalls::gts {

int16_t GT_EnableGantry(Call& call) {
  motion::MotionCore& core = call.card.motion;
  const size_t master = NumberOf(call);
  const size_t slave = NumberOf(call, 1);
  if (master == slave) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("axis {0} cannot be both sides of a gantry",
                                   "轴 {0} 不能同时作为龙门的主轴与从轴", master + 1));
  }
  const motion::Gantry& gantry = core.part<&motion::MotionState::gantry>();
  if (gantry.on) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("axes {0} and {1} are a gantry already, call GT_DisableGantry",
                                   "轴 {0} 与轴 {1} 已构成龙门，请调用 GT_DisableGantry",
                                   gantry.master + 1, gantry.slave + 1));
  }
  int16_t code = CheckAxisAtRest(call, master);
  if (code == vm::kOk) code = CheckAxisAtRest(call, slave);
  if (code != vm::kOk) return code;
  core.EnableGantry(master, slave, call.value(2), call.value(3));
  return vm::kOk;
}

int16_t GT_DisableGantry(Call& call) {
  const motion::Gantry& gantry = call.card.motion.part<&motion::MotionState::gantry>();
  if (!gantry.on) return vm::kOk;
  const int16_t code = CheckAxisAtRest(call, gantry.master);
  if (code != vm::kOk) return code;
  call.card.motion.DisableGantry();
  return vm::kOk;
}

int16_t GT_SetGantryErrLmt(Call& call) {
  call.card.motion.SetGantryErrorLimit(call.integer(0));
  return vm::kOk;
}

int16_t GT_GetGantryErrLmt(Call& call) {
  call.Set(0, call.card.motion.part<&motion::MotionState::gantry>().error_limit);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
