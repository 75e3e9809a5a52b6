// The state machine of a drive (CiA 402-2, "power drive system"): which state a control word leads
// to, and what the status word says of a state. One transition per bus cycle. Tested by
// tests/motion/bus/drive_states_test.cc.
#pragma once

#include <cstdint>
#include <string_view>

namespace oncard::motion::bus {

enum class DriveState : uint8_t {
  kNotReady,
  kSwitchOnDisabled,
  kReadyToSwitchOn,
  kSwitchedOn,
  kOperationEnabled,
  kQuickStopActive,
  kFaultReactionActive,
  kFault
};
inline constexpr int kDriveStateCount = 8;

/// `switch-on disabled` ...
std::string_view NameOf(DriveState state);

/// Bits of the control word 6040h.
inline constexpr uint16_t kControlNewSetPoint = 1u << 4;  ///< mode 1
inline constexpr uint16_t kControlStartHoming = 1u << 4;  ///< mode 6
inline constexpr uint16_t kControlImmediately = 1u << 5;  ///< mode 1
inline constexpr uint16_t kControlRelative = 1u << 6;     ///< mode 1
inline constexpr uint16_t kControlFaultReset = 1u << 7;
inline constexpr uint16_t kControlHalt = 1u << 8;

/// Commands of a control word without its mode bits.
inline constexpr uint16_t kControlShutdown = 0x06;
inline constexpr uint16_t kControlSwitchOn = 0x07;
inline constexpr uint16_t kControlEnable = 0x0F;

/// Bits of the status word 6041h.
inline constexpr uint16_t kStatusFault = 1u << 3;
inline constexpr uint16_t kStatusRemote = 1u << 9;
inline constexpr uint16_t kStatusTargetReached = 1u << 10;
inline constexpr uint16_t kStatusInternalLimit = 1u << 11;
inline constexpr uint16_t kStatusSetPointAcknowledged = 1u << 12;  ///< mode 1
inline constexpr uint16_t kStatusHomingAttained = 1u << 12;        ///< mode 6
inline constexpr uint16_t kStatusFollowsTarget = 1u << 12;         ///< modes 8, 9, 10
inline constexpr uint16_t kStatusFollowingError = 1u << 13;        ///< modes 1, 8
inline constexpr uint16_t kStatusHomingError = 1u << 13;           ///< mode 6

/// The state after one bus cycle with this control word; `before` is the previous one, as a fault
/// is reset by an edge. States that a drive leaves by itself: kNotReady, kFaultReactionActive.
/// The end of a quick stop is not here, as it depends on the motor.
DriveState NextState(DriveState state, uint16_t control, uint16_t before);

/// The bits of the status word that say the state, with "voltage enabled".
uint16_t StatusOf(DriveState state);
/// The state that a status word says.
DriveState StateOf(uint16_t status);

}  // namespace oncard::motion::bus
