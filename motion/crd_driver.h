// A coordinate system at work: its registers and FIFOs, its start and its stop. It maps the motion
// along its path to its profiles, executes buffered commands and waits for moves that they start.
//
// Lanes neither hold nor read a coordinate system: a card stays in them while registers are set and
// slots appended, and leaves them for what changes profiles. All but SetUp() need one that has been
// set up. Tested by tests/motion/crd_test.cc and handles_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "motion/crd_port.h"
#include "motion/paths/crd.h"
#include "motion/profiles/profile.h"

namespace oncard::motion {

/// Where the members among the profiles of a card are: relative to the origin, or by the map.
Coordinates PositionOf(const Crd& crd, std::span<const Profile> profiles);

class CrdDriver {
 public:
  CrdDriver(CoreParts core, size_t crd) : crd_(core.state.crds[crd]), card_(core, crd) {}

  // --- Registers -------------------------------------------------------------------------------

  /// GT_SetCrdPrm: the profiles, which must be at rest, change to mode Crd, and the FIFOs are
  /// emptied.
  void SetUp(CrdParameters parameters);
  /// GT_SetCrdStopDec, pulse/ms^2 > 0.
  void SetStopDecelerations(double smooth, double abrupt);
  /// How the path stops at a limit of one of its axes.
  void SetLimitStop(bool smooth) { crd_.limit_stop.smooth = smooth; }
  /// The largest velocity of a coordinate, pulse/ms, for segments that begin from now on.
  void SetVelocityMax(size_t coordinate, double velocity) {
    crd_.axis_velocity_max[coordinate] = velocity;
  }
  /// The same of the path (CrdParameters), and the velocity with which a run begins and ends.
  void SetPathVelocityMax(double velocity) { crd_.parameters.velocity_max = velocity; }
  void SetStartVelocity(double velocity) { crd_.start.velocity = velocity; }
  /// Moves the origin of a coordinate while no path runs and nothing waits in its FIFOs.
  void SetOrigin(size_t coordinate, double position) { crd_.origin[coordinate] = position; }
  /// These act on the segment that is being executed, too.
  void SetStepMode(bool on);
  void SetOverride(double ratio);
  void SetSecondOverride(double ratio);

  // --- The map -----------------------------------------------------------------------------------

  /// Axes follow the path as a map says, which maps none yet. The path is at 0.
  void BeginMap();
  /// Maps the axis of a profile at rest, which changes to mode Crd. The path is found anew from the
  /// axes; coordinates that they do not determine are 0.
  void MapAxis(size_t axis, const MapRow& row);
  /// By how much the velocity of an axis may change at once, > 0.
  void SetJump(size_t axis, double velocity);
  /// A stop of an axis stops the path, or the axis alone, which then leaves the map.
  void SetStopsTogether(bool together) { crd_.map->stops_together = together; }
  /// Forgets that an axis has stopped the path.
  void ForgetHold() { crd_.map->held = false; }
  /// Takes an axis out of the map.
  void LeaveMap(size_t axis);

  // --- FIFOs -----------------------------------------------------------------------------------

  /// Appends a slot to a FIFO; false when there is no room.
  bool Append(size_t fifo, const PathSlot& slot);
  /// Moves what is in the look-ahead of a FIFO to the FIFO; false if it did not fit.
  bool Flush(size_t fifo) { return crd_.fifos[fifo].Flush(); }
  /// Empties a FIFO, which does not run, and its look-ahead, and discards the breakpoint.
  void Clear(size_t fifo) { crd_.Clear(fifo); }
  /// The number of future segments (GT_SetUserSegNum).
  void SetUserNumber(size_t fifo, int32_t number) { crd_.fifos[fifo].user_number = number; }
  /// How fast the joints between the segments of a FIFO are passed that no planner plans.
  void SetJoints(size_t fifo, JointRule joints) { crd_.fifos[fifo].list.joints = joints; }
  /// The last segment of a FIFO ends at rest.
  void RestAfterLast(size_t fifo) { crd_.RestAfterLast(fifo, card_.now()); }
  /// What waits in a FIFO leaves the coordinates from `first` on where they are now.
  void KeepCoordinates(size_t fifo, size_t first);
  /// Where the next segment begins.
  void SetTail(size_t fifo, const Coordinates& tail) { crd_.fifos[fifo].Tail() = tail; }
  /// GT_InitLookAhead: slots pass a look-ahead of so many segments, for a corner time in ms and an
  /// acceleration in pulse/ms^2. It must be empty.
  void BeginLookAhead(size_t fifo, double time, double acceleration, size_t capacity);
  /// The same with a planner of all axes. Its path begins at rest where the FIFO ends.
  void BeginPlanner(size_t fifo, const PathLimits& limits, size_t capacity);
  /// From now on only the time is computed that the segments of its planner take, from `begin` on.
  void BeginVirtualRun(size_t fifo, const Coordinates& begin);
  /// The planners of all axes end, which must be empty.
  void DropPlanners();

  // --- The run ---------------------------------------------------------------------------------

  /// Begins or resumes a run; with `single_step` it ends after one segment.
  void Start(size_t fifo, bool single_step);
  /// Begins a run with a line back to the breakpoint (Crd::Resume).
  void Resume(size_t fifo, const PathSlot& back);
  /// Stops a run along its path.
  void Stop(bool abrupt);
  /// Ends a run at once: the path rests where it is.
  void Halt();
  /// A profile that it drives has to stop.
  void StopFor(size_t profile, bool abrupt);
  /// Opens a list: a run that has come to its end waits for more slots.
  void OpenList(size_t fifo) { crd_.fifos[fifo].list.open = true; }
  /// Closes it; a run that waits for its data ends.
  void CloseList(size_t fifo);
  /// One cycle of a run, in the cycle of the core.
  void Advance();

 private:
  /// Reports that a planner makes the corner before its newest segment slower than both segments.
  void TellJunction(const CrdFifo& fifo) const;
  /// Reports that a run ended because its FIFO was empty.
  void TellRunEnd() const;
  /// Executes a buffered command, at the tick in which the segment before it ended.
  void CarryOut(const BufferedCommand& command);
  void StartMove(const BufferedCommand& command);
  void StartGear(const BufferedCommand& command);
  /// True if the profile that the path waits for is still moving.
  bool AwaitedMoveUnderWay() const;
  /// Ends the wait if the profile has arrived, and pauses the run if the profile was stopped before
  /// its target.
  void JudgeAwaitedMove();
  /// Writes the outputs of the member profiles and of GT_BufGear profiles for the current point of
  /// the path.
  void Write();
  /// The same for the profiles of mapped axes.
  void WriteMapped(const Coordinates& tangent, const Coordinates& curvature);
  /// Writes them after a verb that may have ended a run; `ran`: there was one. Without a run they
  /// may have been placed elsewhere, or have left.
  void WriteEnd(bool ran);

  Crd& crd_;
  CrdPort card_;
};

}  // namespace oncard::motion
