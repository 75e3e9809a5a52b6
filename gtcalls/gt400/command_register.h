// The command register (GT_GetCmdSts): why the last operating command was refused. Source: GT
// manual tables 2-1 and 2-2. Tested by tests/gtcalls/gt400/card_command_test.cc.
#pragma once

#include <cstdint>

namespace oncard::gtcalls {
struct Call;
}  // namespace oncard::gtcalls

namespace oncard::gtcalls::gt400 {

/// A command that is known but not simulated.
inline constexpr int16_t kNotSimulated = 8;

enum CommandCause : uint16_t {
  kOverflow = 1u << 0,     ///< a position, a velocity, an acceleration or a ratio beyond its range
  kIllegal = 1u << 1,      ///< an illegal parameter, or not a command of this card
  kEmptyMask = 1u << 2,    ///< GT_MltiUpdt(0)
  kDriveOn = 1u << 3,      ///< GT_DrvRst while the drive is enabled
  kNoInterrupt = 1u << 4,  ///< no event interrupt is in service
  kModeInUse = 1u << 6,    ///< another mode while the axis moves
  kIndexBusy = 1u << 7,    ///< GT_CaptIndex while it is armed, or before its event is cleared
  kHomeBusy = 1u << 8,     ///< the same of GT_CaptHome
  kAlarm = 1u << 9,        ///< GT_AxisOn after an alarm
  kInMotion = 1u << 11,    ///< not in motion
  kPathState = 1u << 12,   ///< a path command that the list or the motion forbids
  kListOrder = 1u << 13,   ///< not here in the list
  kListFull = 1u << 15,    ///< send the same command again
};

/// Acts after every command, with its code, which it returns (Family::finish). The register gets
/// the cause of a refusal, and 0 after an operating command, which is one that changes the card. A
/// refusal is also an event of the current axis or, for path commands, a bit of their status. Codes
/// 7, 8 and those below 0 come from the library: the card does not hear of the command.
int16_t WriteCommandRegister(Call& call, int16_t code);

}  // namespace oncard::gtcalls::gt400
