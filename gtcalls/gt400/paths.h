// The path of a card: a coordinate system which mapped axes follow, its runs and stops, and its
// part in a cycle. Source: GT manual chapter 5. Tested by
// tests/gtcalls/gt400/path_command_test.cc, list_command_test.cc and path_stop_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"
#include "gtcalls/gt400/path_state.h"

namespace oncard::gtcalls::gt400 {

/// The coordinate system. A card that has not used its path yet has none.
const motion::Crd& CrdOf(const CardView& card);
/// The same to command it. It is set up when it is needed first.
motion::CrdDriver DriverOf(Card& card);

/// GT_GetAccLmt: by how much the velocity of an axis may change at a joint.
double JumpLimitOf(const CardView& card, size_t axis);
/// True if a path is under way, which may be the list's.
bool PathRuns(const CardView& card);
bool ListRuns(const CardView& card);
/// GT_GetCrdSts: the only place that knows its bits.
uint16_t PathStatusWord(const CardView& card);

/// Runs a segment at once.
void StartSegment(Card& card, const motion::PathSlot& segment);
/// Runs the list from wherever the path is.
void StartList(Card& card);
/// Closes the list, and a run that waits for its data.
void CloseList(Card& card);
/// Stops what runs, at once or along the path, and closes the list.
void StopPath(Card& card, bool at_once);
/// To be called after a command, which may have stopped the path by what it did with an axis. The
/// end is one of all axes that followed.
void NoticePathStop(Card& card);
/// In the tick: axes stop the path; it may have ended.
void AdvancePath(Card& card);

}  // namespace oncard::gtcalls::gt400
