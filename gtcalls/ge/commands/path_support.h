// Internal to gtcalls: what the commands of path cards have in common. Checks are made in this
// order: the card, the list and the motion, the geometry, feed and acceleration, room (assumption).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "gtcalls/ge/commands/commands.h"
#include "gtcalls/ge/path_state.h"
#include "motion/paths/crd.h"

namespace oncard::gtcalls::ges {

/// Feeds and accelerations are in (0, kPathRateMax].
inline constexpr double kPathRateMax = 32767;

// Codes of GE manual table 2-1.
inline constexpr int16_t kListClosed = -1;
inline constexpr int16_t kNoRadius = 2;
inline constexpr int16_t kNoLength = 3;
inline constexpr int16_t kBadRate = 4;
inline constexpr int16_t kChordTooLong = 5;

/// Half of what a chord may exceed the diameter by: one pulse.
inline constexpr double kChordTolerance = 0.5;

inline Path& PathIn(const Card& card) { return *card.state<GeState>().path; }
inline Path& PathOf(const Call& call) { return PathIn(call.card); }
inline List& ListOf(const Call& call) { return PathOf(call).list; }

/// The coordinate system of all axes. A card that has not moved yet has none.
const motion::Crd& CrdOf(const Card& card);
/// The same to command it. It is set up when it is needed first.
motion::CrdDriver DriverOf(Card& card);

/// True if a path is under way, which may be the list's.
bool PathRuns(const Card& card);
bool ListRuns(const Card& card);
/// True if the list has segments or commands that have not been executed.
bool ListWaits(const Card& card);

int16_t RefusePath(Call& call, int16_t code, CommandCause cause, Message why);
/// 0, or 1 with this cause while a path moves.
int16_t CheckNoPath(Call& call, CommandCause cause);
/// 0, or 1 with this cause while the list is open.
int16_t CheckListClosed(Call& call, CommandCause cause);
/// 0, or 1 while an axis has an alarm, or follows the hand wheel.
int16_t CheckAxesFree(Call& call);
/// 0, or 1 if the card has fewer axes.
int16_t CheckAxisCount(Call& call, size_t needed);
/// 0, or 1 unless the list is open and has its start, by the kind of command that gave it.
int16_t CheckListBegun(Call& call, bool looks_ahead);
/// 0, or 1 if the buffer has no room for these words.
int16_t CheckRoom(Call& call, uint32_t words);
int16_t RefuseFull(Call& call, int16_t code = vm::kRefused);
/// 0, or 4 unless a rate is in (0, kPathRateMax], or in [0, kPathRateMax].
int16_t CheckRate(Call& call, size_t argument, bool may_be_zero = false);

/// True for commands of positioning moves, which rest at both ends and have an override of their
/// own.
inline bool IsG0(const Command& command) {
  return command.name.find("G0") != std::string_view::npos;
}

/// A command as an element of a buffer.
motion::PathSlot CommandSlot(const motion::BufferedCommand& command);
/// What GT_BufIOBit has left for the beginning of the next segment; the last one of an output
/// counts.
motion::BufferedCommand BitsOf(const BetweenSegments& between);
/// Appends a command to the list.
void AppendCommand(Card& card, const motion::BufferedCommand& command);
/// Appends a segment and what waits for its beginning; `words`: of the segment alone.
void AppendSegment(Card& card, motion::PathSlot slot, uint32_t words);

/// Runs a FIFO from where the axes are.
void StartPath(Card& card, size_t fifo);
/// Stops what runs, and closes the list.
void StopPath(Card& card, bool emergency);
/// Takes note of a run that has been stopped or has ended. To be called after each cycle, and after
/// commands that may end a run.
void NoticePath(Card& card);

/// One cycle of the hand wheel.
void NoticeWheel(Card& card);

}  // namespace oncard::gtcalls::ges
