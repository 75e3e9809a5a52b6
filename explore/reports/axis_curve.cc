#include "explore/reports/axis_curve.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/markup.h"
#include "base/milliseconds.h"

namespace oncard::explore {
namespace {

constexpr std::string_view kPosition = ".prfPos";
/// Characters between the smallest and the greatest position.
constexpr int kBarWidth = 32;
/// Number of instants shown after the last statement.
constexpr int kTailRows = 8;

constexpr double kPictureWidth = 480;
constexpr double kPictureHeight = 240;
constexpr std::string_view kColors[] = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd"};

double MsOf(const runtime::TraceRow& row) { return ToMs(row.time_us); }

}  // namespace

AxisCurve::AxisCurve(const runtime::Trace* trace) : trace_(trace) {
  if (trace == nullptr || trace->rows().empty()) return;
  for (size_t column = 0; column < trace->columns().size(); ++column) {
    if (!trace->columns()[column].quantity.name.ends_with(kPosition)) continue;
    const runtime::RowLog::Range range = trace->rows().RangeOf(column);
    if (range.greatest > range.least) lines_.push_back({column, range.least, range.greatest});
  }
}

void AxisCurve::ReadUpTo(double at_ms) {
  if (!reader_ || at_ms < at_ms_) {
    std::vector<size_t> columns;
    for (const Line& line : lines_) columns.push_back(line.column);
    reader_.emplace(trace_->rows(), std::move(columns));
    reader_->Next();
    // Also before the first row.
    positions_ = reader_->row().values;
    has_next_ = reader_->Next();
  }
  at_ms_ = at_ms;
  while (has_next_ && MsOf(reader_->row()) <= at_ms) {
    positions_ = reader_->row().values;
    has_next_ = reader_->Next();
  }
}

std::string AxisCurve::BarAt(double at_ms) {
  if (lines_.empty()) return {};
  ReadUpTo(at_ms);
  std::string bars;
  for (size_t i = 0; i < lines_.size(); ++i) {
    const Line& line = lines_[i];
    const double part = (positions_[i] - line.least) / (line.greatest - line.least);
    std::string bar(kBarWidth, ' ');
    bar[static_cast<size_t>(std::lround(part * (kBarWidth - 1)))] = '*';
    bars += fmt::format("   {} {:.6g} |{}|", trace_->columns()[line.column].quantity.name,
                        positions_[i], bar);
  }
  return bars;
}

std::vector<double> AxisCurve::TailAfter(double at_ms) const {
  std::vector<double> instants;
  if (lines_.empty()) return instants;
  const double end = MsOf(trace_->rows().last());
  const double cycle = ToMs(trace_->cycle_us());
  const auto cycles = static_cast<int64_t>(std::lround((end - at_ms) / cycle));
  const int64_t rows = std::min<int64_t>(kTailRows, cycles);
  for (int64_t i = 1; i <= rows; ++i) {
    const int64_t whole = cycles * i / rows;
    instants.push_back(at_ms + static_cast<double>(whole) * cycle);
  }
  return instants;
}

std::string AxisCurve::Svg() const {
  if (lines_.empty()) return {};
  double least = lines_.front().least;
  double greatest = lines_.front().greatest;
  for (const Line& line : lines_) {
    least = std::min(least, line.least);
    greatest = std::max(greatest, line.greatest);
  }
  const double end = std::max(MsOf(trace_->rows().last()), MsOf(trace_->rows().front()) + 1e-3);
  constexpr double kMargin = 20;
  std::string svg = fmt::format(
      "<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\">\n"
      "<text x=\"{2}\" y=\"14\">{3:.6g}</text>\n<text x=\"{2}\" y=\"{4}\">{5:.6g}</text>\n"
      "<text x=\"{6}\" y=\"{4}\" text-anchor=\"end\">{7:.6g} ms</text>\n",
      kPictureWidth, kPictureHeight, 2, greatest, kPictureHeight - 4, least, kPictureWidth - 2,
      end);
  for (size_t i = 0; i < lines_.size(); ++i) {
    std::string points;
    double last_y = 0;
    runtime::RowLog::Reader reader(trace_->rows(), {lines_[i].column});
    while (reader.Next()) {
      const runtime::TraceRow& row = reader.row();
      const double part = (row.values.front() - least) / (greatest - least);
      const double x = MsOf(row) / end * kPictureWidth;
      last_y = kPictureHeight - kMargin - part * (kPictureHeight - 2 * kMargin);
      points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", x, last_y);
    }
    const std::string_view color = kColors[i % std::size(kColors)];
    svg += fmt::format(
        "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" points=\"{}\"/>\n"
        "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\" fill=\"{}\">{}</text>\n",
        color, points, kPictureWidth - 2, last_y - 4, color,
        EscapeMarkup(trace_->columns()[lines_[i].column].quantity.name));
  }
  return svg + "</svg>\n";
}

}  // namespace oncard::explore
