// A coordinate system at work: it maps the motion along its path to its profiles, executes buffered
// commands and waits for moves that they start. Tested by tests/motion/crd_test.cc.
#pragma once

#include <cstddef>
#include <span>

#include "motion/crd_port.h"
#include "motion/paths/crd.h"
#include "motion/profiles/profile.h"

namespace oncard::motion {

/// The positions of the members among the profiles of a card, relative to the origin.
Coordinates PositionOf(const Crd& crd, std::span<const Profile> profiles);

class CrdDriver {
 public:
  CrdDriver(Crd& crd, CrdPort card) : crd_(crd), card_(card) {}

  /// Gives it new parameters: the profiles, which must be at rest, change to mode Crd, and the
  /// FIFOs are emptied.
  void SetUp(CrdParameters parameters);
  /// Appends a slot to a FIFO; false when there is no room.
  bool Append(size_t fifo, const PathSlot& slot);
  /// Begins or resumes a run; with `single_step` it ends after one segment.
  void Start(size_t fifo, bool single_step);
  /// Begins a run with a line back to the breakpoint (Crd::Resume).
  void Resume(size_t fifo, const PathSlot& back);
  /// Stops a run along its path.
  void Stop(bool abrupt);
  /// Opens a list: a run that has come to its end waits for more slots.
  void OpenList(size_t fifo) { crd_.fifos[fifo].list.open = true; }
  /// Closes it; a run that waits for its data ends.
  void CloseList(size_t fifo);
  /// One cycle of a run.
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

  Crd& crd_;
  CrdPort card_;
};

}  // namespace oncard::motion
