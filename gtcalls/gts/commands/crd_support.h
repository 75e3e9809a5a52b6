// Internal to gtcalls: common parts of the commands of coordinate systems.
#pragma once

#include <string_view>
#include <vector>

#include "gtcalls/gts/commands/motion_support.h"
#include "motion/paths/crd.h"

namespace oncard::gtcalls::gts {

/// The coordinate system that argument 0 numbers, to read and to command it.
inline const motion::Crd& CrdOf(const Call& call) {
  return call.card.motion.part<&motion::MotionState::crds>()[NumberOf(call)];
}
inline motion::CrdDriver CrdAt(const Call& call) { return call.card.motion.CrdAt(NumberOf(call)); }

/// 0, or 1 with the reason when the coordinate system `crd` (from 0) has not been set up.
int16_t CheckCrd(Call& call, size_t crd);

/// The argument with that name; the command must have it.
size_t ArgumentIndex(const Call& call, std::string_view name);
/// The FIFO that the command's last arguments name.
size_t FifoNumber(const Call& call);
inline const motion::CrdFifo& FifoOf(const Call& call) {
  return CrdOf(call).fifos[FifoNumber(call)];
}

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

/// The bit of coordinate system 1 in a mask of axes (GT_Stop, GT_SynchAxisPos).
inline constexpr unsigned kFirstCrdBit = 12;
/// Assumption: its bit on cards of up to 8 axes, which have the other one too.
inline constexpr unsigned kFirstCrdBitTo8Axes = 8;
/// The coordinate systems whose bits such a mask has: bit 0 is coordinate system 1.
uint32_t CrdBitsOf(uint32_t axis_mask, size_t axis_count);

}  // namespace oncard::gtcalls::gts
