// Follow: a profile's position is a table over its master's displacement, as PT's is one over time.
//
// Two FIFOs hold segments; each segment gives the cumulative displacement of master and slave since
// the pass began. Within a segment the ratio of the velocities is constant or linear in the
// master's displacement. A pass goes once through a FIFO; the distance that the master is beyond
// the end of one pass is part of the next pass, so that no rounding accumulates. Source: GTS manual
// 7.6. Tested by tests/motion/follow_mode_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/common/sample.h"
#include "motion/profiles/master.h"

namespace oncard::motion {

/// How the ratio of the velocities changes within a segment.
enum class FollowSegmentType : uint8_t {
  kNormal,    ///< begins with the last ratio of the segment before; the first with 0
  kEven,      ///< constant
  kStop,      ///< ends with 0
  kContinue,  ///< like kNormal, but the first begins with the last ratio of the pass before
};

struct FollowSegment {
  int32_t master = 0;  ///< pulses since the pass began, cumulative
  double slave = 0;    ///< the same of the slave
  FollowSegmentType type = FollowSegmentType::kNormal;

  auto Fields(auto visit) const { return visit(master, slave, type); }
};

/// Segments of a FIFO with GT_SetFollowMemory 0 and 1.
inline constexpr std::array<size_t, 2> kFollowSegments = {16, 512};

/// When a started slave begins to follow.
enum class FollowEvent : uint8_t {
  kStart,  ///< at once
  kPass,   ///< when the master passes a position
};

struct FollowMode {
  // Registers.
  int8_t direction = 0;  ///< GT_PrfFollow
  Master master;
  int32_t loop = 0;  ///< passes; < 1: endless (assumption: the default is endless)
  FollowEvent event = FollowEvent::kStart;
  int8_t event_direction = 1;  ///< of the master at the event position: 1, -1
  int32_t event_position = 0;
  bool large_memory = false;
  std::array<std::vector<FollowSegment>, 2> fifos;

  // The run.
  bool running = false;
  bool waiting = false;    ///< for the event
  uint8_t fifo = 0;        ///< the FIFO in use, chosen before Start()
  bool switching = false;  ///< switch to the other FIFO at the end of this pass
  int32_t passes = 0;      ///< passes completed since the FIFO was started
  uint32_t segment = 0;
  double slave_base = 0;   ///< the slave's position at the begin of the pass
  double pass_ratio = 0;   ///< at the end of the pass before
  double first_ratio = 0;  ///< at the begin of the segment, and next at its end
  double last_ratio = 0;
  MasterTravel travel;  ///< since the pass' begin

  size_t Capacity() const { return kFollowSegments[large_memory ? 1 : 0]; }
  size_t Space(size_t which) const { return Capacity() - fifos[which].size(); }
  /// Reserves the capacity of the FIFOs, so that filling and clearing them never allocates in a
  /// cycle.
  void SetMemory(bool large);

  /// The direction, as a sign, in which a start with a FIFO that is not empty would move the slave
  /// at once; 0: it would not move.
  double Direction(uint8_t which, const MasterValue& value) const;
  /// Begins the first pass of `fifo`, which must not be empty, or waits for the event.
  void Start(const Sample& from, const MasterValue& value);
  /// The slave's output; ends the run after the last pass.
  Sample At(const Sample& now, const MasterValue& value);
  /// Ends the run because something else controls the profile; data and registers are kept.
  void Halt() { running = false; }

  auto Fields(auto visit) const {
    return visit(direction, master, loop, event, event_direction, event_position, large_memory,
                 fifos, running, waiting, fifo, switching, passes, segment, slave_base, pass_ratio,
                 first_ratio, last_ratio, travel);
  }

 private:
  bool EventBetween(double before, double after) const;
  /// Sets the ratios of segment `segment` from the ratio before it.
  void EnterSegment(double ratio_before);
  /// Skips whole passes at once if the master has moved far.
  void SkipPasses();
  /// Moves forward or back to the segment that the master is in. False: the run is over.
  bool FindSegment();
  /// True when there is a next pass.
  bool NextPass();
  FollowSegment BeginOf(uint32_t index) const;
  /// The position of the master in a segment, as a fraction.
  double PartOf(uint32_t index) const;
};

}  // namespace oncard::motion
