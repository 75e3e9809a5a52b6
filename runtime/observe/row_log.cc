#include "runtime/observe/row_log.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

namespace oncard::runtime {
namespace {

bool SameBits(double a, double b) {
  return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

void Include(double value, RowLog::Range* range) {
  range->least = std::min(range->least, value);
  range->greatest = std::max(range->greatest, value);
}

// The last row says when the log ends.
bool AddsNothing(const RowLog::Reader& reader, const TraceRow& before) {
  const TraceRow& row = reader.row();
  return row.values == before.values && (!reader.AtLast() || row.time_us == before.time_us);
}

std::vector<size_t> AllColumns(size_t count) {
  std::vector<size_t> columns(count);
  std::iota(columns.begin(), columns.end(), size_t{0});
  return columns;
}

}  // namespace

RowLog::Range RowLog::RangeOf(size_t column) const {
  Range range = ranges_[column];
  if (packed_ == 0) range = {last_.values[column], last_.values[column]};
  Include(last_.values[column], &range);
  return range;
}

size_t RowLog::bytes() const {
  return std::accumulate(
      columns_.begin(), columns_.end(), instants_.bytes(),
      [](size_t sum, const PackedColumn& column) { return sum + column.bytes(); });
}

void RowLog::Add(int64_t time_us, std::span<const double> values) {
  PackLast();
  last_.time_us = time_us;
  last_.values.assign(values.begin(), values.end());
  last_.inside_cycle = false;
}

void RowLog::Repeat(int64_t time_us, bool inside_cycle) {
  PackLast();
  last_.time_us = time_us;
  last_.inside_cycle = inside_cycle;
}

void RowLog::PackLast() {
  if (!std::exchange(has_last_, true)) return;
  // The lowest bit is the flag, so that rows at equal distances are as predicted.
  instants_.Append(static_cast<double>(last_.time_us * 2 + (last_.inside_cycle ? 1 : 0)));
  if (packed_ == 0) {
    first_ = last_;
    before_ = last_.values;
    for (size_t i = 0; i < columns_.size(); ++i) {
      columns_[i].Append(before_[i]);
      ranges_[i] = {before_[i], before_[i]};
    }
  }
  for (size_t i = 0; i < columns_.size(); ++i) {
    const double value = last_.values[i];
    if (SameBits(value, before_[i])) continue;
    before_[i] = value;
    columns_[i].Repeat(packed_ - columns_[i].size());
    columns_[i].Append(value);
    Include(value, &ranges_[i]);
  }
  ++packed_;
}

void RowLog::Keep(const std::vector<size_t>& columns) {
  const bool all_differ = AllRowsDiffer(columns);
  RemoveOtherColumns(columns);
  if (!all_differ) RemoveEqualRows();
}

bool RowLog::AllRowsDiffer(const std::vector<size_t>& columns) const {
  Reader reader(*this, columns);
  if (!reader.Next()) return true;
  TraceRow before = reader.row();
  while (reader.Next()) {
    if (AddsNothing(reader, before)) return false;
    before = reader.row();
  }
  return true;
}

void RowLog::RemoveOtherColumns(const std::vector<size_t>& columns) {
  const auto keep = [&columns](auto& values) {
    if (values.empty()) return;  // of no row yet
    for (size_t i = 0; i < columns.size(); ++i) {
      if (columns[i] != i) values[i] = std::move(values[columns[i]]);
    }
    values.resize(columns.size());
  };
  keep(columns_);
  keep(ranges_);
  keep(first_.values);
  keep(before_);
  keep(last_.values);
}

void RowLog::RemoveEqualRows() {
  RowLog kept(columns_.size());
  Reader reader(*this);
  while (reader.Next()) {
    const TraceRow& row = reader.row();
    if (!kept.empty() && AddsNothing(reader, kept.last_)) continue;
    kept.Add(row.time_us, row.values);
    kept.last_.inside_cycle = row.inside_cycle;
  }
  *this = std::move(kept);
}

RowLog::Reader::Reader(const RowLog& log) : Reader(log, AllColumns(log.columns_.size())) {}

RowLog::Reader::Reader(const RowLog& log, std::vector<size_t> columns)
    : log_(&log), columns_(std::move(columns)), instants_(log.instants_) {
  values_.reserve(columns_.size());
  for (const size_t column : columns_) values_.emplace_back(log.columns_[column]);
  row_.values.resize(columns_.size());
}

bool RowLog::Reader::Next() {
  if (read_ < log_->packed_) {
    const auto instant = static_cast<int64_t>(instants_.Next());
    row_.time_us = instant / 2;
    row_.inside_cycle = instant % 2 != 0;
    for (size_t i = 0; i < values_.size(); ++i) row_.values[i] = values_[i].Next();
  } else if (read_ == log_->packed_ && log_->has_last_) {
    row_.time_us = log_->last_.time_us;
    row_.inside_cycle = log_->last_.inside_cycle;
    for (size_t i = 0; i < values_.size(); ++i) row_.values[i] = log_->last_.values[columns_[i]];
  } else {
    return false;
  }
  ++read_;
  return true;
}

}  // namespace oncard::runtime
