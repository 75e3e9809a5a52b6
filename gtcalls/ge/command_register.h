// The command register (GT_GetCmdSts): why the last command was refused. Source: GE manual tables
// 2-3 and 2-4.
#pragma once

#include <cstdint>

namespace oncard::gtcalls {
struct Call;
}  // namespace oncard::gtcalls

namespace oncard::gtcalls::ge {

enum CommandCause : uint16_t {
  kOverflow = 1u << 0,     ///< PX: a value beyond its range
  kIllegal = 1u << 1,      ///< an illegal parameter; on PX also motion during an alarm
  kEmptyMask = 1u << 2,    ///< GT_MltiUpdt(0)
  kDriveOn = 1u << 3,      ///< the drive is enabled
  kCaptureBusy = 1u << 5,  ///< the capture is armed, or its event is not cleared
  kModeInUse = 1u << 6,    ///< the mode cannot be changed now
  kPathState = 1u << 8,    ///< SX: a path command that the list or the motion forbids, or a figure
  kAlarm = 1u << 9,        ///< PX: GT_AxisOn during an alarm
  kListState = 1u << 9,    ///< SX: the list is open or not, the path moves or has nothing to do
  kInMotion = 1u << 11,    ///< not in motion
  kNotOnCard = 1u << 14,   ///< SX: not a command of this card
  kBufferFull = 1u << 15,  ///< SX: send the same command again
};

/// Why a command was refused: what it has said itself. Otherwise its arguments are wrong, and the
/// cause is kOverflow for a value beyond its range, kIllegal for the number of something that the
/// card does not have, for NULL, and for a command that is not supported (assumption: table 2-3
/// only calls the first "overflow" and the other "illegal").
uint16_t CauseOf(const Call& call);

/// The register after a command with its code and cause: that of the last one only, which reading
/// it does not clear. Returns the code.
int16_t WriteCommandRegister(Call& call, int16_t code, uint16_t cause);

}  // namespace oncard::gtcalls::ge
