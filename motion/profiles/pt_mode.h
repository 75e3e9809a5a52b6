// Motion through position/time segments (mode PT).
//
// Two buffers hold segments. Static: a run executes one of them, repeated according to the loop
// register, and the data is kept. Dynamic: the buffers take turns; a completed buffer is emptied
// and can be filled again, and the run ends when both are empty. Positions count from where the run
// began, and times from its begin (of each pass, when static). Source: GTS manual 7.4. Tested by
// tests/motion/pt_mode_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/common/sample.h"
#include "motion/common/sizes.h"

namespace oncard::motion {

/// Segments of one buffer: GT_SetPtMemory 0 and 1.
inline constexpr size_t kPtSmallBuffer = 32;
inline constexpr size_t kPtLargeBuffer = 1024;

enum class PtSegmentType : uint8_t {
  kNormal,  ///< begins with the end velocity of the one before; the first with 0
  kEven,    ///< constant velocity
  kStop,    ///< ends at rest
};

/// Constant acceleration over `duration` ms.
struct PtSegment {
  double begin = 0;         ///< position, pulse
  double end = 0;           ///< position, pulse
  double velocity = 0;      ///< at its begin, pulse/ms
  double end_velocity = 0;  ///< pulse/ms
  int32_t begin_time = 0;   ///< ms
  int32_t end_time = 0;     ///< ms
  int32_t number = 0;       ///< the user's (GT_PtDataWN)

  auto Fields(auto visit) const {
    return visit(begin, end, velocity, end_velocity, begin_time, end_time, number);
  }
};

struct PtMode {
  // Registers.
  bool dynamic = false;       ///< GT_PrfPt
  bool large_memory = false;  ///< GT_SetPtMemory
  int32_t loop_target = 1;    ///< passes of a static run; 0: endless
  std::array<std::vector<PtSegment>, 2> buffers;
  uint32_t write_buffer = 0;  ///< the dynamic buffer that is being filled
  PtSegment last;             ///< of dynamic data, also when its buffer has been emptied

  // The run.
  bool running = false;
  uint32_t run_buffer = 0;  ///< of GT_PtStart, or the current one of a dynamic run
  uint32_t index = 0;       ///< of the segment in execution
  Micros begin = 0;         ///< of the run, or of the pass
  double origin = 0;        ///< position at `begin`
  int32_t loop_count = 0;   ///< passes of a static run that are over
  int32_t number = 0;       ///< of the segment executed last

  size_t capacity() const { return large_memory ? kPtLargeBuffer : kPtSmallBuffer; }
  /// Selects how the buffers are used; a change empties them.
  void SetDynamic(bool value);
  /// Free space in segments; in dynamic mode independent of the buffer.
  size_t Space(size_t buffer) const;
  /// The begin of a segment that is appended now, ms; it must end later.
  int32_t LastTime(size_t buffer) const;
  /// Appends a segment that begins at the end of the last one. There must be space.
  void Append(size_t buffer, double position, int32_t time, PtSegmentType type,
              int32_t segment_number);
  /// Empties a buffer; in dynamic mode both.
  void Clear(size_t buffer);
  /// True if a run would have data.
  bool HasData(size_t buffer) const;
  bool Empty() const { return buffers[0].empty() && buffers[1].empty(); }
  /// Segments after the one in execution; at rest, those that a run would execute.
  size_t Remainder() const;

  /// The sign is the direction of the first motion of the data; 0: there is none.
  double Direction(size_t buffer) const;
  /// Begins a run where the profile is: through `run_buffer`, or through the dynamic data. There
  /// must be data.
  void Start(Micros now, const Sample& from);
  /// The profile's output; ends the run when its data is used up.
  Sample At(Micros now);
  /// Something else has taken over; dynamic data is dropped (assumption).
  void Halt();

  auto Fields(auto visit) const {
    return visit(dynamic, large_memory, loop_target, buffers, write_buffer, last, running,
                 run_buffer, index, begin, origin, loop_count, number);
  }

 private:
  /// The segment that the next one follows; nullptr at the begin.
  const PtSegment* LastSegment(size_t buffer) const;
  /// Leaves `run_buffer` after its last segment. False if nothing is left to run.
  bool NextBuffer();
};

}  // namespace oncard::motion
