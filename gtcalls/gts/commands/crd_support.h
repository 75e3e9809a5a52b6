// Internal to gtcalls: common parts of the commands of coordinate systems.
#pragma once

#include <string_view>
#include <vector>

#include "gtcalls/gts/commands/motion_support.h"
#include "motion/paths/crd.h"

namespace oncard::gtcalls {

/// The coordinate system that argument 0 numbers.
inline motion::Crd& CrdOf(const Call& call) {
  return call.card.motion.state().crds[NumberOf(call)];
}

/// 0, or 1 with the reason when the coordinate system `crd` (from 0) has not been set up.
int16_t CheckCrd(Call& call, size_t crd);

/// The argument with that name; the command must have it.
size_t ArgumentIndex(const Call& call, std::string_view name);
/// The FIFO that the command's last arguments name.
size_t FifoNumber(const Call& call);
inline motion::CrdFifo& FifoOf(const Call& call) { return CrdOf(call).fifos[FifoNumber(call)]; }

/// Where a segment appended now begins.
motion::Coordinates PathEnd(const Call& call);

/// Measures the segment as the planner of the command's FIFO does, if it has one.
void MeasureForPlanner(const Call& call, motion::Segment* segment);

/// 0, or 107 with the reason when the command in pulses is for a FIFO that GT_InitLookAheadEx has
/// prepared for commands in mm.
int16_t CheckNotMixed(Call& call);
/// Appends a slot of a command in pulses to its FIFO: 0, or 1 with the reason when it is full.
int16_t AppendSlot(Call& call, const motion::PathSlot& slot);
/// The same for all commands; `end` is where the path ends before.
int16_t AppendToFifo(Call& call, const motion::PathSlot& slot, const motion::Coordinates& end);

/// Coordinate systems (from 0) whose bits `mask` has; bit 0 is coordinate system 1.
std::vector<size_t> CrdsOf(uint32_t mask);

/// Coordinate systems that a mask of axes selects as well (GT_Stop): bits 8 and 9, on a card with
/// 12 axes 12 and 13.
std::vector<size_t> CrdsOfAxisMask(const Call& call, double mask);
/// The bit of such a mask for coordinate system 1.
unsigned FirstCrdBit(const Call& call);

}  // namespace oncard::gtcalls
