// Motion of single axes: modes, updates, stops. Setters write registers, which an Update makes
// valid. Source: GT manual 4.1 to 4.4. Tested by tests/gtcalls/gt400/motion_command_test.cc and
// update_command_test.cc.
#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/gt400/gears.h"
#include "gtcalls/gt400/registers.h"
#include "gtcalls/gt400/stops.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::ProfileMode;

/// A mode is chosen at once, without an Update. A gear slave may leave the gear in motion.
int16_t ChooseMode(Call& call, ProfileMode mode) {
  const size_t axis = CurrentAxis(call);
  const bool geared = call.card.motion.profile(axis).mode == ProfileMode::kGear;
  if (!geared && Moves(call.card.view(), axis)) {
    return RefuseFor(call, kModeInUse,
                     MakeMessage("axis {0} is moving, its mode can change at rest only",
                                 "轴 {0} 正在运动，仅可在静止时切换模式", axis + 1));
  }
  if (geared) call.card.motion.ProfileAt(axis).Stop(true);
  call.card.motion.ProfileAt(axis).SelectMode(mode);
  return vm::kOk;
}

}  // namespace

int16_t GT_PrflT(Call& call) { return ChooseMode(call, ProfileMode::kTrap); }
int16_t GT_PrflS(Call& call) { return ChooseMode(call, ProfileMode::kSCurve); }
int16_t GT_PrflV(Call& call) { return ChooseMode(call, ProfileMode::kJog); }

int16_t GT_PrflG(Call& call) {
  const size_t axis = CurrentAxis(call);
  const int master = call.integer(0);
  if (master == static_cast<int>(axis) + 1) {
    return call.Refuse(vm::kBadParameter, MakeMessage("axis {0} cannot be its own master",
                                                      "轴 {0} 不能以自身为主轴", master));
  }
  const int16_t code = ChooseMode(call, ProfileMode::kGear);
  if (code == vm::kOk) ChooseMaster(call.card, axis, master);
  return code;
}

// --- Updates ---------------------------------------------------------------------------------

namespace {

int16_t Update(Call& call, uint32_t axes) {
  if (call.ticked) return vm::kOk;
  if (auto refusal = TakeUpdate(call.card, axes)) {
    return RefuseFor(call, kInMotion, *std::move(refusal));
  }
  return call.WaitForTick();
}

}  // namespace

int16_t GT_Update(Call& call) { return Update(call, uint32_t{1} << CurrentAxis(call)); }

int16_t GT_MltiUpdt(Call& call) {
  constexpr uint32_t kAxes = (1u << kAxisMax) - 1;
  const uint32_t mask = static_cast<uint32_t>(call.integer(0)) & kAxes;
  if (mask != 0) return Update(call, mask);
  return RefuseFor(call, kEmptyMask,
                   {"the mask names no axis; bit 0 is axis 1", "mask 未指定轴；第 0 位对应轴 1"});
}

int16_t GT_AuUpdtOn(Call& call) {
  CurrentState(call).auto_update = true;
  return vm::kOk;
}

int16_t GT_AuUpdtOff(Call& call) {
  CurrentState(call).auto_update = false;
  return vm::kOk;
}

// --- Commands that wait for an Update --------------------------------------------------------

int16_t GT_SmthStp(Call& call) {
  CurrentState(call).request.smooth_stop = true;
  return vm::kOk;
}

int16_t GT_SynchPos(Call& call) {
  CurrentState(call).request.synch_position = true;
  return vm::kOk;
}

// --- Stops -----------------------------------------------------------------------------------

/// It ends the motion, also one that has ended, and forgets the target velocity.
int16_t GT_AbptStp(Call& call) {
  StopAbruptly(call.card, CurrentAxis(call));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gt400
