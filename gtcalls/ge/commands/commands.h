// Internal to gtcalls: the commands of GE cards, one function each, and what they have in common.
// The families share the functions in `ge`; those in `gep` are for point-to-point cards, those in
// `ges` for path cards; both use their own where both exist. As in gtcalls/gts/commands, arguments
// have passed the checks of the catalogue, and a refused command changes nothing but the command
// register and the event bit of the axis.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"
#include "gtcalls/ge/command_register.h"
#include "gtcalls/ge/ge_state.h"

namespace oncard::gtcalls::ge {

#define COMMAND(number, name, ...) int16_t name(Call& call);
#include "gtcalls/ge/common.def"
#undef COMMAND
#undef TOPIC

/// The axis that the first argument numbers, counted from 0.
inline size_t AxisOf(const Call& call) { return static_cast<size_t>(call.integer(0) - 1); }
inline GeState& StateOf(const Call& call) { return call.card.state<GeState>(); }
inline GeAxis& GeAxisOf(const Call& call) { return StateOf(call).axes[AxisOf(call)]; }

/// Refuses a command for an axis with 1.
int16_t RefuseAxis(Call& call, size_t axis, CommandCause cause, Message why);
/// 0, or 1 with this cause while the drive of the axis is enabled, or while the axis moves.
int16_t CheckDriveOff(Call& call, CommandCause cause);
int16_t CheckAtRest(Call& call, CommandCause cause);

/// The same while the drive of the axis reports an alarm that counts.
int16_t CheckNoAlarm(Call& call, CommandCause cause);
/// Refuses a mask without axes.
int16_t RefuseEmptyMask(Call& call);

/// True if the axis is controlled by a voltage now.
bool IsAnalogue(const Card& card, size_t axis);
/// Connects the drive of the axis as GT_CtrlMode and GT_OpenLp say.
void ConnectDrive(Card& card, size_t axis);
/// Gives the servo controller of the axis the working values of its registers.
void UpdateServo(Card& card, size_t axis);

/// Sets the planned, the target and the actual position of an axis at rest; the machine stays.
void PlaceAxis(Card& card, size_t axis, int32_t position);
/// Enables a drive. Motion of the axis ends, and its plan begins where it is.
void EnableDrive(Card& card, size_t axis);

}  // namespace oncard::gtcalls::ge

namespace oncard::gtcalls::gep {

using namespace ge;

int16_t GT_AxisOn(Call& call);
int16_t GT_Update(Call& call);
int16_t GT_MltiUpdt(Call& call);
#define COMMAND(number, name, ...) int16_t name(Call& call);
#include "gtcalls/ge/px.def"
#undef COMMAND
#undef TOPIC

}  // namespace oncard::gtcalls::gep

namespace oncard::gtcalls::ges {

using namespace ge;

int16_t GT_AlarmOn(Call& call);
int16_t GT_AlarmOff(Call& call);
int16_t GT_AxisOn(Call& call);
int16_t GT_AxisOff(Call& call);
int16_t GT_StepDir(Call& call);
int16_t GT_StepPulse(Call& call);
int16_t GT_Update(Call& call);
int16_t GT_MltiUpdt(Call& call);
int16_t GT_SetKp(Call& call);
int16_t GT_SetKi(Call& call);
int16_t GT_SetKd(Call& call);
int16_t GT_SetKvff(Call& call);
int16_t GT_SetKaff(Call& call);
int16_t GT_SetILmt(Call& call);
int16_t GT_SetMtrLmt(Call& call);
int16_t GT_SetMtrBias(Call& call);
#define COMMAND(number, name, ...) int16_t name(Call& call);
#include "gtcalls/ge/sx.def"
#undef COMMAND
#undef TOPIC

}  // namespace oncard::gtcalls::ges
