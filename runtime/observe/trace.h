// A trace: values over virtual time, with one row per profile cycle in which anything changed, and
// one per edge of a high-speed output between two cycles; and its three text formats. Deterministic
// and locale-free; every text ends in a newline. Tested by tests/runtime/trace_test.cc and
// tests/tools/run_command_test.cc.
#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "base/text_pieces.h"
#include "runtime/observe/quantity.h"
#include "runtime/observe/row_log.h"

namespace oncard::runtime {

struct TraceColumn {
  Quantity quantity;
  /// Dropped at the end if the value has not changed by more than `threshold`.
  bool only_if_changed = false;
  double threshold = 0;
};

/// A thread was running from one instant to the other.
struct TraceSpan {
  int thread = 0;
  std::string function;
  int64_t begin_us = 0;
  int64_t end_us = 0;
};

/// An event at an instant: the host wrote a variable, or the card did something by itself
/// (card_event_text.h).
struct TraceMark {
  int64_t time_us = 0;
  Message text;
  bool by_card = false;
};

/// The default columns of a trace, used if they change: values of axes and the other parts of the
/// card, inputs and outputs.
std::vector<TraceColumn> DefaultColumns(const Controller& controller);

class Trace {
 public:
  /// Sample() reads the columns from a controller; a column with the name of an earlier one is left
  /// out.
  explicit Trace(std::vector<TraceColumn> columns);

  /// Records the current values if they differ from the last row; the first ones always.
  void Sample(const Controller& controller);
  /// Always records the current values, so that the trace reaches the end of the run, and drops
  /// default columns that never changed.
  void Finish(const Controller& controller);
  /// Records an action of the host at this instant.
  void Mark(const Controller& controller, std::string text);
  /// Records something that the card does by itself, possibly before the first sample.
  void Mark(TraceMark mark) { marks_.push_back(std::move(mark)); }

  const std::vector<TraceColumn>& columns() const { return columns_; }
  const RowLog& rows() const { return rows_; }
  const std::vector<TraceSpan>& spans() const { return spans_; }
  const std::vector<TraceMark>& marks() const { return marks_; }
  NumberForm form(size_t column) const { return forms_[column]; }
  /// Length of the longest profile cycle.
  int64_t cycle_us() const { return cycle_us_; }
  /// True if velocities are per cycle, as the card's commands count them.
  bool per_cycle() const { return per_cycle_; }

  /// `time_ms,sum,gpo`, then a line per row.
  void WriteCsv(const TextSink& sink) const;
  /// Value change dump (IEEE 1364 clause 18), time scale 1 us: ints as 32-bit words, flags as
  /// wires, doubles as reals. Columns of one part of the card share a scope.
  void WriteVcd(const TextSink& sink) const;
  /// Trace events for chrome://tracing and Perfetto: a counter per column, a thread of durations
  /// for every thread that ran, instants for marks.
  void WriteJson(const TextSink& sink) const;

 private:
  /// Reads the current values into sample_.
  void ReadColumns(const Controller& controller);
  void SampleThreads(const Controller& controller, int64_t time_us);
  /// Adds rows for the edges of high-speed outputs since the last sample.
  void AddOutputEdges(const Controller& controller, int64_t time_us);
  void DropUnchanged();

  std::vector<TraceColumn> columns_;
  std::vector<NumberForm> forms_;  // of the columns, known with the first row
  RowLog rows_;
  std::vector<double> sample_;    // the values that are being sampled
  std::vector<TraceSpan> spans_;  // in order of their ends
  std::vector<TraceSpan> open_;   // of the threads that run now
  std::bitset<vm::kThreadCount> running_;
  std::vector<TraceMark> marks_;
  int64_t cycle_us_ = 0;
  bool per_cycle_ = false;
  int64_t sampled_us_ = 0;  // the last sample
};

}  // namespace oncard::runtime
