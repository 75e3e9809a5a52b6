// The positions of a card's axes during a run, as a curve beside its statements. Deterministic.
// Tested by tests/explore/step_table_test.cc.
#pragma once

#include <cstddef>
#include <optional>
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
  /// `   axis1.prfPos 12.5 |    *     |`. Empty without a curve. Fast for one instant after the
  /// other.
  std::string BarAt(double at_ms);
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
  void ReadUpTo(double at_ms);

  const runtime::Trace* trace_;
  std::vector<Line> lines_;
  // Where BarAt() is.
  double at_ms_ = 0;
  std::vector<double> positions_;                  // of the lines, at that instant
  std::optional<runtime::RowLog::Reader> reader_;  // at the next row
  bool has_next_ = false;
};

}  // namespace oncard::explore
