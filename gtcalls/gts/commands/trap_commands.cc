// Point-to-point motion and Jog. Setters write registers; GT_Update commits them.
// Source: GTS manual 7.2, 7.3 and chapter 13. Tested by tests/gtcalls/trap_command_test.cc.
#include "gtcalls/gts/commands/motion_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::ProfileMode;

/// Assumption: limits of accelerations. The manual only says > 0; outside these limits a motion
/// would last years, or the velocity would change by more than a double can represent accurately.
constexpr double kAccelerationMin = kAboveZero;
constexpr double kAccelerationMax = 1e9;

/// Maximum of TTrapPrm.velStart, as for velocities.
constexpr double kStartVelocityMax = 32767;

/// False, with the reason recorded, unless the value of the member is in [minimum, maximum]; a NaN
/// is not.
bool CheckMember(Call& call, std::string_view name, double value, double minimum, double maximum) {
  if (value >= minimum && value <= maximum) return true;
  call.reason = MakeMessage("{0} is {1}; the range is [{2}, {3}]",
                            "{0} 为 {1}；取值范围为 [{2}, {3}]", name, value, minimum, maximum);
  return false;
}

/// Checks acc and dec, the first two members of TTrapPrm and TJogPrm. dec is 0 until it is set: the
/// manual makes acc its default.
bool CheckAccelerations(Call& call) {
  const double dec = call.cells(1)[1];
  return CheckMember(call, "acc", call.cells(1)[0], kAccelerationMin, kAccelerationMax) &&
         (dec == 0 || CheckMember(call, "dec", dec, kAccelerationMin, kAccelerationMax));
}

}  // namespace

int16_t GT_PrfTrap(Call& call) { return ChooseMode(call, NumberOf(call), ProfileMode::kTrap); }
int16_t GT_PrfJog(Call& call) { return ChooseMode(call, NumberOf(call), ProfileMode::kJog); }

// --- Trap ------------------------------------------------------------------------------------

int16_t GT_SetTrapPrm(Call& call) {
  const double start = call.cells(1)[2];
  const double smooth = call.cells(1)[3];
  if (!CheckAccelerations(call) || !CheckMember(call, "velStart", start, 0, kStartVelocityMax) ||
      !CheckMember(call, "smoothTime", smooth, 0, kSmoothTimeMax)) {
    return vm::kBadParameter;
  }
  const int16_t code = CheckModeAtRest(call, NumberOf(call), ProfileMode::kTrap);
  if (code != vm::kOk) return code;
  ProfileAt(call).SetParameters(motion::TrapParameters{call.cells(1)[0], call.cells(1)[1], start,
                                                       static_cast<int16_t>(smooth)});
  return vm::kOk;
}

int16_t GT_GetTrapPrm(Call& call) {
  const int16_t code = CheckMode(call, NumberOf(call), ProfileMode::kTrap);
  if (code != vm::kOk) return code;
  const motion::TrapParameters& parameters = ProfileOf(call).trap.parameters;
  call.Set(1, parameters.acc, 0);
  call.Set(1, parameters.dec, 1);
  call.Set(1, parameters.vel_start, 2);
  call.Set(1, parameters.smooth_time, 3);
  return vm::kOk;
}

int16_t GT_SetPos(Call& call) {
  int16_t code = CheckMode(call, NumberOf(call), ProfileMode::kTrap);
  if (code == vm::kOk) code = CheckNotHoming(call, NumberOf(call));
  if (code == vm::kOk) ProfileAt(call).SetTarget(call.integer(1));
  return code;
}

int16_t GT_GetPos(Call& call) {
  const int16_t code = CheckMode(call, NumberOf(call), ProfileMode::kTrap);
  if (code == vm::kOk) call.Set(1, ProfileOf(call).trap.target);
  return code;
}

// --- Jog -------------------------------------------------------------------------------------

int16_t GT_SetJogPrm(Call& call) {
  const double smooth = call.cells(1)[2];
  if (!CheckAccelerations(call)) return vm::kBadParameter;
  if (!(smooth >= 0 && smooth < 1)) {
    return call.Refuse(vm::kBadParameter, MakeMessage("smooth is {0}; the range is [0, 1)",
                                                      "smooth 为 {0}；取值范围为 [0, 1)", smooth));
  }
  const int16_t code = CheckModeAtRest(call, NumberOf(call), ProfileMode::kJog);
  if (code != vm::kOk) return code;
  ProfileAt(call).SetParameters(motion::JogParameters{call.cells(1)[0], call.cells(1)[1], smooth});
  return vm::kOk;
}

int16_t GT_GetJogPrm(Call& call) {
  const int16_t code = CheckModeAtRest(call, NumberOf(call), ProfileMode::kJog);
  if (code != vm::kOk) return code;
  const motion::JogParameters& parameters = ProfileOf(call).jog.parameters;
  call.Set(1, parameters.acc, 0);
  call.Set(1, parameters.dec, 1);
  call.Set(1, parameters.smooth, 2);
  return vm::kOk;
}

// --- Both ------------------------------------------------------------------------------------

namespace {

/// 0, or 1 with the reason if GT_Update and GT_SetVel have no effect in the profile's mode.
int16_t CheckUpdated(Call& call, size_t profile) {
  const ProfileMode mode = call.card.motion.profile(profile).mode;
  if (mode == ProfileMode::kTrap || mode == ProfileMode::kJog) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("profile {0} is in mode {1}; this needs mode Trap or Jog, call "
                                 "GT_PrfTrap or GT_PrfJog",
                                 "规划器 {0} 处于 {1} 模式；该指令需要 Trap 或 Jog 模式，请调用 "
                                 "GT_PrfTrap 或 GT_PrfJog",
                                 profile + 1, NameOf(mode)));
}

}  // namespace

int16_t GT_SetVel(Call& call) {
  int16_t code = CheckUpdated(call, NumberOf(call));
  if (code == vm::kOk) code = CheckNotHoming(call, NumberOf(call));
  if (code == vm::kOk) ProfileAt(call).SetVelocity(call.value(1));
  return code;
}

int16_t GT_GetVel(Call& call) {
  const int16_t code = CheckUpdated(call, NumberOf(call));
  if (code != vm::kOk) return code;
  const motion::Profile& profile = ProfileOf(call);
  const bool trap = profile.mode == ProfileMode::kTrap;
  call.Set(1, trap ? profile.trap.velocity : profile.jog.velocity);
  return vm::kOk;
}

namespace {

/// The sign is the direction in which the registers would move the profile.
double DirectionOf(const motion::Profile& profile) {
  return profile.mode == ProfileMode::kTrap ? profile.trap.target - profile.now.position
                                            : profile.jog.velocity;
}

}  // namespace

int16_t GT_Update(Call& call) {
  const std::vector<size_t> profiles = SelectedProfiles(call);
  if (profiles.empty()) return vm::kRefused;
  for (const size_t i : profiles) {
    int16_t code = CheckUpdated(call, i);
    if (code == vm::kOk) code = CheckNotHoming(call, i);
    if (code == vm::kOk) {
      code = CheckMayStart(call, i, DirectionOf(call.card.motion.profile(i)));
    }
    if (code != vm::kOk) return code;
  }
  for (const size_t i : profiles) call.card.motion.ProfileAt(i).Start();
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
