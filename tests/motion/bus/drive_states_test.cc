// The state machine of a drive against the table of CiA 402-2: one transition per bus cycle.
#include "motion/bus/drive_states.h"

#include <gtest/gtest.h>

namespace oncard::motion::bus {
namespace {

using enum DriveState;

constexpr DriveState kStates[] = {
    kNotReady,         kSwitchOnDisabled, kReadyToSwitchOn,     kSwitchedOn,
    kOperationEnabled, kQuickStopActive,  kFaultReactionActive, kFault};

/// For each command the next states, in the order of kStates.
struct TransitionRow {
  uint16_t control;
  DriveState next[kDriveStateCount];
};

constexpr TransitionRow kTable[] = {
    // disable voltage
    {0x00,
     {kSwitchOnDisabled, kSwitchOnDisabled, kSwitchOnDisabled, kSwitchOnDisabled, kSwitchOnDisabled,
      kSwitchOnDisabled, kFault, kFault}},
    // quick stop
    {0x02,
     {kSwitchOnDisabled, kSwitchOnDisabled, kSwitchOnDisabled, kSwitchOnDisabled, kQuickStopActive,
      kQuickStopActive, kFault, kFault}},
    // shutdown
    {0x06,
     {kSwitchOnDisabled, kReadyToSwitchOn, kReadyToSwitchOn, kReadyToSwitchOn, kReadyToSwitchOn,
      kQuickStopActive, kFault, kFault}},
    // switch on, which is "disable operation" when it is enabled
    {0x07,
     {kSwitchOnDisabled, kSwitchOnDisabled, kSwitchedOn, kSwitchedOn, kSwitchedOn, kQuickStopActive,
      kFault, kFault}},
    // enable operation
    {0x0F,
     {kSwitchOnDisabled, kSwitchOnDisabled, kSwitchedOn, kOperationEnabled, kOperationEnabled,
      kOperationEnabled, kFault, kFault}},
};

TEST(DriveStates, FollowTheTableOfTheStandard) {
  for (const TransitionRow& row : kTable) {
    for (int i = 0; i < kDriveStateCount; ++i) {
      EXPECT_EQ(NextState(kStates[i], row.control, row.control), row.next[i])
          << std::hex << row.control << " in " << NameOf(kStates[i]);
    }
  }
}

TEST(DriveStates, AnEdgeResetsAFault) {
  EXPECT_EQ(NextState(kFault, kControlFaultReset, 0), kSwitchOnDisabled);
  EXPECT_EQ(NextState(kFault, kControlFaultReset, kControlFaultReset), kFault);
}

TEST(DriveStates, AreReadBackFromTheStatusWord) {
  for (const DriveState state : kStates) {
    EXPECT_EQ(StateOf(StatusOf(state) | kStatusRemote), state) << NameOf(state);
  }
}

TEST(DriveStates, HaveTheStatusBitsOfTheStandard) {
  const std::pair<DriveState, uint16_t> kBits[] = {{kNotReady, 0x00},
                                                   {kSwitchOnDisabled, 0x40},
                                                   {kReadyToSwitchOn, 0x21},
                                                   {kSwitchedOn, 0x23},
                                                   {kOperationEnabled, 0x27},
                                                   {kQuickStopActive, 0x07},
                                                   {kFaultReactionActive, 0x0F},
                                                   {kFault, 0x08}};
  for (const auto& [state, bits] : kBits) {
    EXPECT_EQ(StatusOf(state) & 0x6F, bits) << NameOf(state);
  }
}

}  // namespace
}  // namespace oncard::motion::bus
