// Values over virtual time: one row per profile cycle in which anything changed, and three ways to
// write them down. Deterministic and locale-free; every text ends in a newline.
// Tested by tests/runtime/scenario_run_test.cc and tests/tools/run_command_test.cc.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/quantity.h"

namespace oncard::runtime {

struct TraceRow {
  int64_t time_us = 0;
  std::vector<double> values;  ///< one per column
};

class Trace {
 public:
  /// Columns are read from a controller by Sample().
  explicit Trace(std::vector<Quantity> columns) : columns_(std::move(columns)) {}

  /// Keeps the values of this moment when they differ from the last row's, and the first always.
  void Sample(const Controller& controller);
  /// Keeps the values of this moment in any case, so that the trace lasts to the end of the run.
  void Finish(const Controller& controller);

  const std::vector<Quantity>& columns() const { return columns_; }
  const std::vector<TraceRow>& rows() const { return rows_; }

  /// `time_ms,sum,gpo`, then a line per row.
  std::string Csv() const;
  /// Value change dump (IEEE 1364 clause 18), time scale 1 us; ints as 32-bit words, doubles as
  /// reals.
  std::string Vcd() const;
  /// {"time_unit":"ms","columns":[...],"rows":[[time, ...], ...]}
  std::string Json() const;

 private:
  TraceRow Row(const Controller& controller) const;

  std::vector<Quantity> columns_;
  std::vector<vm::DataType> types_;  // of the columns, known with the first row
  std::vector<TraceRow> rows_;
};

}  // namespace oncard::runtime
