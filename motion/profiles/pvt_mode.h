// Motion through a PVT table (mode PVT).
//
// The time of the table's first point delays the start, once. A pass lasts from the first point to
// the last; passes follow one another without a gap, and their positions add up. A table that is
// selected during a run is used from the end of the current pass. Source: GTS manual 7.7. Tested by
// tests/motion/pvt_mode_test.cc.
#pragma once

#include <cstdint>

#include "motion/common/sample.h"
#include "motion/common/sizes.h"
#include "motion/profiles/pvt_table.h"

namespace oncard::motion {

struct PvtMode {
  // Registers.
  int32_t loop_target = 1;  ///< passes of a run; 0: endless
  uint16_t selected = 0;    ///< table, counted from 0

  // The run.
  bool running = false;
  PvtTablePointer table;  ///< content at the start of the run, or at the selection
  PvtTablePointer next;   ///< used from the start, or from the end of the pass; nullptr: none
  uint16_t current = 0;   ///< number of `table`
  Micros begin = 0;       ///< of the run
  double pass_begin = 0;  ///< when the table's first point is passed, ms after `begin`
  double origin = 0;      ///< position of the table's first point
  int32_t loop_count = 0;
  double time = 0;  ///< of the table, at the last instant

  /// Selects a table; `chosen` is its content, nullptr if it is empty (allowed only at rest).
  void Select(uint16_t number, PvtTablePointer chosen);
  /// Begins a run where the profile is through `next`, the content of the selected table.
  void Start(Micros now, const Sample& from);
  /// The profile's output; ends the run after its last pass.
  Sample At(Micros now);
  /// Something else has taken over; the registers stay.
  void Halt();

  auto Fields(auto visit) const {
    return visit(loop_target, selected, running, table, next, current, begin, pass_begin, origin,
                 loop_count, time);
  }

 private:
  /// Makes the selected table `next` the current one.
  void TakeNext();
  /// Begins another pass; false if there is none.
  bool NextPass();
};

}  // namespace oncard::motion
