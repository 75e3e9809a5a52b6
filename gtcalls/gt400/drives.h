// What an axis and its drive have to do with each other: outputs, servo controllers, positions.
// Source: GT manual 3.2, 3.3, 4.4. Tested by tests/gtcalls/gt400/axis_command_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"

namespace oncard::gtcalls::gt400 {

/// True if the axis is controlled by a voltage now.
bool IsAnalogue(const Card& card, size_t axis);
/// True if GT_SetMtrCmd sets that voltage, and no plan does.
bool IsInOpenLoop(const Card& card, size_t axis);
/// True if a plan would reach the drive of the axis, and its mode does not leave it to a path.
bool CanPlan(const Card& card, size_t axis);
/// Connects the drive of the axis as GT_CtrlMode and GT_OpenLp say.
void ConnectDrive(Card& card, size_t axis);
/// Gives the analogue output of the axis its valid bias and limit or, in open loop, what it puts
/// out.
void UpdateOutput(Card& card, size_t axis);
/// Gives the servo controller of the axis its valid registers.
void UpdateServo(Card& card, size_t axis);
/// Sets the planned, the target and the actual position of an axis at rest; the machine stays.
void PlaceAxis(Card& card, size_t axis, int32_t position);

}  // namespace oncard::gtcalls::gt400
