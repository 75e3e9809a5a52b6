// The rows of a trace: instants, and the values of all columns at each. They are packed
// (packed_column.h) except for the last one, which may still change, so that an hour of moving axes
// fits into memory. Rows are read in order. Tested by tests/runtime/row_log_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/observe/packed_column.h"

namespace oncard::runtime {

struct TraceRow {
  int64_t time_us = 0;
  std::vector<double> values;  ///< one per column
  /// A high-speed output changed inside a cycle; the other values are those of the row before.
  bool inside_cycle = false;
};

class RowLog {
 public:
  class Reader;

  /// The least and the greatest value of a column. NaNs are passed over, but if the first value is
  /// one, so are both.
  struct Range {
    double least = 0;
    double greatest = 0;
  };

  explicit RowLog(size_t columns = 0) : columns_(columns), ranges_(columns) {}

  bool empty() const { return !has_last_; }
  /// There must be a row.
  const TraceRow& front() const { return packed_ == 0 ? last_ : first_; }
  const TraceRow& last() const { return last_; }
  Range RangeOf(size_t column) const;
  /// Memory that the packed rows take.
  size_t bytes() const;

  /// Appends a row with a value for each column. Instants are not negative and below 2^52 us.
  void Add(int64_t time_us, std::span<const double> values);
  /// Appends a row with the values of the last one.
  void Repeat(int64_t time_us, bool inside_cycle);
  /// Changes a value in the last row.
  void SetLast(size_t column, double value) { last_.values[column] = value; }
  /// Removes the columns other than these, which are in order, and rows that then equal the one
  /// before; a row at the last instant remains.
  void Keep(const std::vector<size_t>& columns);

 private:
  void PackLast();
  bool AllRowsDiffer(const std::vector<size_t>& columns) const;
  void RemoveOtherColumns(const std::vector<size_t>& columns);
  void RemoveEqualRows();

  PackedColumn instants_;  // see PackLast()
  // A column ends with its last change; the same value follows up to the last packed row.
  std::vector<PackedColumn> columns_;
  std::vector<Range> ranges_;  // of the packed rows
  TraceRow first_;
  std::vector<double> before_;  // values of the last packed row
  TraceRow last_;
  size_t packed_ = 0;  // rows
  bool has_last_ = false;
};

/// Reads rows from the first to the last. The log must neither change nor move meanwhile.
class RowLog::Reader {
 public:
  explicit Reader(const RowLog& log);
  /// Only these columns, in this order.
  Reader(const RowLog& log, std::vector<size_t> columns);

  /// Moves on to the next row, at first to the first one. False if there is none.
  bool Next();
  /// The current row.
  const TraceRow& row() const { return row_; }
  /// True if it is the last one.
  bool AtLast() const { return read_ > log_->packed_; }

 private:
  const RowLog* log_;
  std::vector<size_t> columns_;
  PackedColumn::Reader instants_;
  std::vector<PackedColumn::Reader> values_;
  size_t read_ = 0;  // rows
  TraceRow row_;
};

}  // namespace oncard::runtime
