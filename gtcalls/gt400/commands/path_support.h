// Internal to gtcalls: what the path commands of GT400 cards have in common. They judge in this
// order: parameters (7), figures (2 to 6), state (1), velocity and acceleration (4), room (1).
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/gt400/paths.h"

namespace oncard::gtcalls::gt400 {

// Codes of GT manual table 2-1.
inline constexpr int16_t kNoRadius = 2;
inline constexpr int16_t kNoLength = 3;
inline constexpr int16_t kBadRate = 4;
inline constexpr int16_t kBadEnd = 5;
inline constexpr int16_t kNoMapping = 6;

/// The size of coordinates, of positions of axes and of radii is at most this.
inline constexpr double kFarthest = -static_cast<double>(kPositionMin);

inline Path& PathOf(const Call& call) { return StateOf(call).path; }
inline PathList& ListOf(const Call& call) { return PathOf(call).list; }

/// Refuses a command with one of these codes. Assumption: its cause is an illegal parameter.
int16_t RefuseFigure(Call& call, int16_t code, Message why);
/// 0, or 7 if an argument that is a double is no number.
int16_t CheckFinite(Call& call);
/// 0, or 4 unless an argument is a velocity or an acceleration of a path.
int16_t CheckRate(Call& call, size_t argument);
/// 0, or 5 if a point, or the position of an axis there, is beyond the largest position.
int16_t CheckPoint(Call& call, const motion::Coordinates& point);
/// 0, or 1 while a path runs.
int16_t CheckNoPath(Call& call);
/// 0, or 1 unless the list is open and has its start point.
int16_t CheckListBegun(Call& call);
/// 0, or 1 if the buffer has no room for the command.
int16_t CheckRoom(Call& call);

}  // namespace oncard::gtcalls::gt400
