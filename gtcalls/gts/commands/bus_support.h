// Internal to gtcalls: common parts of the commands of axes and I/O on a bus: the refusals that
// they share, and objects in the process data of drives. Source: GTS manual S2, chapters 5 and 13.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "gtcalls/gts/commands/motion_support.h"
#include "motion/bus/bus.h"

namespace oncard::gtcalls::gts {

/// The bus of the card, to read and to change it; nullptr for a card without one.
const motion::bus::Bus* LineOf(const Call& call);
motion::bus::Bus* ChangeLine(const Call& call);
/// 0, or 1 with the reason when the bus is not in operation.
int16_t CheckBus(Call& call);
/// 0, or 1 with the reason when argument 0 is no axis with a drive on the bus that answers.
int16_t CheckBusAxis(Call& call);
/// 0, or 1 with the reason when the drive of an axis on a bus does not obey planned motion: the
/// controller has not been started, or the drive is in another mode than 8. 0 for other axes.
int16_t CheckBusObeys(Call& call, size_t axis);
/// The same without the mode, for enabling it.
int16_t CheckBusStarted(Call& call, size_t axis);

/// The slave of the axis that argument 0 numbers, for an axis on the bus.
size_t BusSlaveOf(const Call& call);
/// 0, or 1 with the reason when the process data of the axis have no such input.
int16_t CheckInput(Call& call, motion::bus::ObjectId id);
/// Reads such an input into argument `output`. 0, or 1 as CheckBusAxis() and CheckInput().
int16_t ReadInput(Call& call, motion::bus::ObjectId id, size_t output);
/// Writes an output that a host commands. 0, or 1 with the reason.
int16_t WriteOutput(Call& call, motion::bus::ObjectId id, int64_t value);

}  // namespace oncard::gtcalls::gts
