// Positions, velocities and accelerations of profiles, axes and encoders: reading and setting them.
// Source: GTS manual chapters 6, 8.1, 11.6 and 13; the public header for GT_GetEncPosPre.
// Tested by tests/gtcalls/position_command_test.cc.
#include <cmath>

#include "gtcalls/gts/commands/crd_support.h"
#include "gtcalls/gts/profile_modes.h"

namespace oncard::gtcalls::gts {

// --- Profiles --------------------------------------------------------------------------------

int16_t GT_GetPrfPos(Call& call) {
  return ReadEach(call, [&](size_t i) { return call.card.motion.profile(i).now.position; });
}

int16_t GT_GetPrfVel(Call& call) {
  return ReadEach(call, [&](size_t i) { return call.card.motion.profile(i).now.velocity; });
}

int16_t GT_GetPrfAcc(Call& call) {
  return ReadEach(call, [&](size_t i) { return call.card.motion.profile(i).now.acceleration; });
}

int16_t GT_GetPrfMode(Call& call) {
  return ReadEach(call, [&](size_t i) { return ModeNumber(call.card.motion.profile(i).mode); });
}

int16_t GT_SetPrfPos(Call& call) {
  const int16_t code = CheckAtRest(call, NumberOf(call));
  if (code == vm::kOk) ProfileAt(call).SetPosition(call.value(1));
  return code;
}

// --- Axes ------------------------------------------------------------------------------------

int16_t GT_GetAxisPrfPos(Call& call) {
  return ReadEach(call, [&](size_t i) { return call.card.motion.axis(i).profile.position; });
}

int16_t GT_GetAxisPrfVel(Call& call) {
  return ReadEach(call,
                  [&](size_t i) { return call.card.motion.axis(i).profile.FilteredVelocity(); });
}

int16_t GT_GetAxisPrfAcc(Call& call) {
  return ReadEach(call, [&](size_t i) { return call.card.motion.axis(i).profile.acceleration; });
}

int16_t GT_GetAxisEncPos(Call& call) {
  return ReadEach(call, [&](size_t i) { return call.card.motion.axis(i).encoder.position; });
}

int16_t GT_GetAxisEncVel(Call& call) {
  return ReadEach(call,
                  [&](size_t i) { return call.card.motion.axis(i).encoder.FilteredVelocity(); });
}

int16_t GT_GetAxisEncAcc(Call& call) {
  return ReadEach(call, [&](size_t i) { return call.card.motion.axis(i).encoder.acceleration; });
}

int16_t GT_GetAxisError(Call& call) {
  return ReadEach(call, [&](size_t i) {
    const motion::Axis& axis = call.card.motion.axis(i);
    return axis.profile.position - axis.encoder.position;
  });
}

namespace {

/// Assumption: the bit of a coordinate system selects the axes to which its profiles are mapped.
void SynchMembers(const Call& call, size_t crd) {
  motion::MotionCore& core = call.card.motion;
  const motion::Crd& system = core.part<&motion::MotionState::crds>()[crd];
  for (size_t axis = 0; axis < core.axis_count(); ++axis) {
    const uint32_t map = core.axis(axis).profile_map;
    for (size_t i = 0; i < system.dimension(); ++i) {
      const auto member = static_cast<unsigned>(system.members[i]);
      if ((map >> member & 1) != 0) core.AxisAt(axis).SynchPosition();
    }
  }
}

}  // namespace

int16_t GT_SynchAxisPos(Call& call) {
  const std::vector<size_t> axes = SelectedProfiles(call);
  const std::vector<size_t> crds =
      CrdsOf(CrdBitsOf(BitWord(call.value(0)), call.card.motion.axis_count()));
  if (axes.empty() && crds.empty()) return vm::kRefused;
  call.reason = {};
  for (const size_t axis : axes) call.card.motion.AxisAt(axis).SynchPosition();
  for (const size_t crd : crds) SynchMembers(call, crd);
  return vm::kOk;
}

int16_t GT_ZeroPos(Call& call) {
  const size_t first = NumberOf(call);
  const size_t end = first + static_cast<size_t>(call.integer(1));
  for (size_t axis = first; axis < end; ++axis) {
    int16_t code = CheckAtRest(call, axis);
    if (code == vm::kOk) code = CheckAxisAtRest(call, axis);
    if (code != vm::kOk) return code;
  }
  for (size_t axis = first; axis < end; ++axis) call.card.motion.AxisAt(axis).ZeroPosition();
  return vm::kOk;
}

// --- Encoders --------------------------------------------------------------------------------

int16_t GT_GetEncPos(Call& call) {
  return ReadEach(call, [&](size_t i) { return call.card.motion.encoder(i).position; });
}

/// Subtracts the counts of the last cycle from the current position, so that setting the position
/// does not appear as a movement.
int16_t GT_GetEncPosPre(Call& call) {
  const double cycle_ms = static_cast<double>(call.card.motion.config().cycle_us) / 1000;
  return ReadEach(call, [&](size_t i) {
    const motion::Encoder& encoder = call.card.motion.encoder(i);
    return encoder.position - std::round(encoder.velocity * cycle_ms);
  });
}

int16_t GT_GetEncVel(Call& call) {
  return ReadEach(call, [&](size_t i) { return call.card.motion.encoder(i).velocity; });
}

int16_t GT_SetEncPos(Call& call) {
  call.card.motion.EncoderAt(NumberOf(call)).SetPosition(call.value(1));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
