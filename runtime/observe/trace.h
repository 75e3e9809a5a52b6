// Values over virtual time: one row per profile cycle in which anything changed, and one per edge
// of a high-speed output between two cycles; and three ways to write them down. Deterministic and
// locale-free; every text ends in a newline. Tested by tests/runtime/trace_test.cc and
// tests/tools/run_command_test.cc.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "runtime/observe/quantity.h"

namespace oncard::runtime {

struct TraceColumn {
  Quantity quantity;
  /// Dropped at the end when the value has not changed by more than `threshold`.
  bool only_if_changed = false;
  double threshold = 0;
};

struct TraceRow {
  int64_t time_us = 0;
  std::vector<double> values;  ///< one per column
  /// A high-speed output changed inside a cycle; the other values are those of the row before.
  bool inside_cycle = false;
};

/// A thread was running from one instant to the other.
struct TraceSpan {
  int thread = 0;
  std::string function;
  int64_t begin_us = 0;
  int64_t end_us = 0;
};

/// Something that happened at an instant: the host wrote a variable, or the card did something by
/// itself (happening_text.h).
struct TraceMark {
  int64_t time_us = 0;
  Message text;
  bool by_card = false;
};

/// Columns that a trace has without being asked, when they change: what axes and the other parts of
/// the card do, inputs and outputs.
std::vector<TraceColumn> DefaultColumns(const Controller& controller);

class Trace {
 public:
  /// Columns are read from a controller by Sample(); one of a name that an earlier one has is left
  /// out.
  explicit Trace(std::vector<TraceColumn> columns);

  /// Keeps the values of this moment when they differ from the last row's, and the first always.
  void Sample(const Controller& controller);
  /// Keeps the values of this moment in any case, so that the trace lasts to the end of the run,
  /// and drops the columns that were only wanted if they change.
  void Finish(const Controller& controller);
  /// The host does something at this moment.
  void Mark(const Controller& controller, std::string text);
  /// The card has done something by itself, or will have, when it happens before the first sample.
  void Mark(TraceMark mark) { marks_.push_back(std::move(mark)); }

  const std::vector<TraceColumn>& columns() const { return columns_; }
  const std::vector<TraceRow>& rows() const { return rows_; }
  const std::vector<TraceSpan>& spans() const { return spans_; }
  const std::vector<TraceMark>& marks() const { return marks_; }
  NumberForm form(size_t column) const { return forms_[column]; }
  /// Length of a profile cycle.
  int64_t cycle_us() const { return cycle_us_; }

  /// `time_ms,sum,gpo`, then a line per row.
  std::string Csv() const;
  /// Value change dump (IEEE 1364 clause 18), time scale 1 us: ints as 32-bit words, flags as
  /// wires, doubles as reals. Columns of one part of the card share a scope.
  std::string Vcd() const;
  /// Trace events for chrome://tracing and Perfetto: a counter per column, a thread of durations
  /// for every thread that ran, instants for marks.
  std::string Json() const;

 private:
  void SampleThreads(const Controller& controller, int64_t time_us);
  /// Rows for what high-speed outputs did since the last sample.
  void AddOutputEdges(const Controller& controller, int64_t time_us);
  void DropUnchanged();

  std::vector<TraceColumn> columns_;
  std::vector<NumberForm> forms_;  // of the columns, known with the first row
  std::vector<TraceRow> rows_;
  std::vector<TraceSpan> spans_;  // in order of their ends
  std::vector<TraceSpan> open_;   // threads that run now
  std::vector<TraceMark> marks_;
  int64_t cycle_us_ = 0;
  int64_t sampled_us_ = 0;  // the last sample
};

}  // namespace oncard::runtime
