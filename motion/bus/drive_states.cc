#include "motion/bus/drive_states.h"

namespace oncard::motion::bus {
namespace {

/// Commands of the control word (CiA 402-2, table "command coding").
enum class Command : uint8_t {
  kDisableVoltage,
  kQuickStop,
  kShutdown,
  kSwitchOn,
  kEnableOperation
};

Command CommandOf(uint16_t control) {
  if ((control & 0x02) == 0) return Command::kDisableVoltage;
  if ((control & 0x04) == 0) return Command::kQuickStop;
  if ((control & 0x01) == 0) return Command::kShutdown;
  return (control & 0x08) == 0 ? Command::kSwitchOn : Command::kEnableOperation;
}

struct Transition {
  DriveState from;
  Command command;
  DriveState to;
};

using enum DriveState;

/// Every other command leaves the state as it is.
constexpr Transition kTransitions[] = {
    {kSwitchOnDisabled, Command::kShutdown, kReadyToSwitchOn},
    {kReadyToSwitchOn, Command::kSwitchOn, kSwitchedOn},
    {kReadyToSwitchOn, Command::kEnableOperation, kSwitchedOn},
    {kReadyToSwitchOn, Command::kDisableVoltage, kSwitchOnDisabled},
    {kReadyToSwitchOn, Command::kQuickStop, kSwitchOnDisabled},
    {kSwitchedOn, Command::kEnableOperation, kOperationEnabled},
    {kSwitchedOn, Command::kShutdown, kReadyToSwitchOn},
    {kSwitchedOn, Command::kDisableVoltage, kSwitchOnDisabled},
    {kSwitchedOn, Command::kQuickStop, kSwitchOnDisabled},
    {kOperationEnabled, Command::kSwitchOn, kSwitchedOn},
    {kOperationEnabled, Command::kShutdown, kReadyToSwitchOn},
    {kOperationEnabled, Command::kDisableVoltage, kSwitchOnDisabled},
    {kOperationEnabled, Command::kQuickStop, kQuickStopActive},
    {kQuickStopActive, Command::kEnableOperation, kOperationEnabled},
    {kQuickStopActive, Command::kDisableVoltage, kSwitchOnDisabled},
};

struct StateRow {
  DriveState state;
  uint16_t status;  ///< bits 0 to 3, 5 and 6, and bit 4: voltage enabled
  std::string_view name;
};

constexpr StateRow kStates[] = {
    {kNotReady, 0x00, "not ready"},
    {kSwitchOnDisabled, 0x40, "switch-on disabled"},
    {kReadyToSwitchOn, 0x31, "ready to switch on"},
    {kSwitchedOn, 0x33, "switched on"},
    {kOperationEnabled, 0x37, "operation enabled"},
    {kQuickStopActive, 0x17, "quick stop active"},
    {kFaultReactionActive, 0x1F, "fault reaction active"},
    {kFault, 0x08, "fault"},
};
static_assert(std::size(kStates) == kDriveStateCount);

/// Bit 5, "quick stop", says nothing outside of these.
constexpr uint16_t MaskOf(DriveState state) {
  const bool any = state == kNotReady || state == kSwitchOnDisabled || state == kFault ||
                   state == kFaultReactionActive;
  return any ? 0x4F : 0x6F;
}

}  // namespace

std::string_view NameOf(DriveState state) { return kStates[static_cast<size_t>(state)].name; }

DriveState NextState(DriveState state, uint16_t control, uint16_t before) {
  if (state == kNotReady) return kSwitchOnDisabled;
  if (state == kFaultReactionActive) return kFault;
  if (state == kFault) {
    return (control & ~before & kControlFaultReset) != 0 ? kSwitchOnDisabled : kFault;
  }
  const Command command = CommandOf(control);
  for (const Transition& transition : kTransitions) {
    if (transition.from == state && transition.command == command) return transition.to;
  }
  return state;
}

uint16_t StatusOf(DriveState state) { return kStates[static_cast<size_t>(state)].status; }

DriveState StateOf(uint16_t status) {
  for (const StateRow& row : kStates) {
    const uint16_t mask = MaskOf(row.state);
    if ((status & mask) == (row.status & mask)) return row.state;
  }
  return kNotReady;
}

}  // namespace oncard::motion::bus
