// The positions of a card's axes during a run, as a curve beside its statements. Deterministic.
// Tested by tests/explore/step_table_test.cc.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "runtime/observe/trace.h"

namespace oncard::explore {

class AxisCurve {
 public:
  /// The planned positions in a trace; no curve if it is nullptr or has none. The trace must
  /// outlive it.
  explicit AxisCurve(const runtime::Trace* trace);

  /// The positions at an instant, each with a mark between the least and the greatest of the run:
  /// `   axis1.prfPos 12.5 |    *     |`. Empty without a curve.
  std::string BarAt(double at_ms) const;
  /// Some later instants, up to the end of the run, while anything moves.
  std::vector<double> TailAfter(double at_ms) const;
  /// A picture for a page; empty without a curve.
  std::string Svg() const;

 private:
  struct Line {
    size_t column = 0;  ///< of the trace
    double least = 0;
    double greatest = 0;
  };
  double ValueAt(const Line& line, double at_ms) const;

  const runtime::Trace* trace_;
  std::vector<Line> lines_;
};

}  // namespace oncard::explore
