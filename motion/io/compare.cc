#include "motion/io/compare.h"

#include <algorithm>
#include <cmath>

#include "motion/common/rounding.h"
#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<HsioOutput> && kFieldsComplete<ComparePoint> &&
              kFieldsComplete<CompareHit> && kFieldsComplete<CompareParameters> &&
              kFieldsComplete<CompareModule> && kFieldsComplete<HsioEdge>);

/// Positions are rounded to whole pulses; a position so close to the middle between two of them
/// counts as beyond it.
constexpr double kHalfPulse = 0.5 - 1e-6;

/// A part of the movement in a cycle, from 0 (its beginning) to 1 (its end).
struct Part {
  double first;
  double last;

  bool empty() const { return first > last; }
  /// Restricts the part to the positions within `half` of `point`, for a movement from `from` by
  /// `length`.
  void Narrow(double from, double length, double point, double half) {
    if (length == 0) {
      if (std::fabs(from - point) > half) last = first - 1;
      return;
    }
    const double a = (point - half - from) / length;
    const double b = (point + half - from) / length;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
};

}  // namespace

double FindHit(double x0, double y0, double x1, double y1, bool use_x, ComparePoint point,
               int max_error, double begin) {
  const double dx = use_x ? x1 - x0 : 0;
  const double dy = y1 - y0;
  Part within{begin, 1};
  within.Narrow(y0, dy, point.y, max_error + kHalfPulse);
  if (use_x) within.Narrow(x0, dx, point.x, max_error + kHalfPulse);
  if (within.empty()) return -1;
  const double length = dx * dx + dy * dy;
  if (length == 0) return begin;
  const double nearest = ((use_x ? (point.x - x0) * dx : 0) + (point.y - y0) * dy) / length;
  if (nearest > 1 && within.last == 1) return -1;
  return std::clamp(nearest, within.first, within.last);
}

void CompareUnit::Reset() {
  modules_ = {};
  log_.clear();
  for (HsioOutput& output : outputs_) output = {.shown = output.shown};
}

void CompareUnit::Pulse(size_t channel, Micros now, int16_t time_us) {
  outputs_[channel].pulse_end = static_cast<double>(now) + time_us;
}

void CompareUnit::SetLevel(size_t channel, bool level) {
  outputs_[channel].level = level;
  outputs_[channel].pulse_end = 0;
}

void CompareUnit::Append(size_t channel, const std::vector<ComparePoint>& points) {
  CompareModule& module = modules_[channel];
  module.points.erase(module.points.begin(),
                      module.points.begin() + static_cast<std::ptrdiff_t>(module.next));
  module.next = 0;
  module.points.insert(module.points.end(), points.begin(), points.end());
}

void CompareUnit::Repeat(size_t channel, int32_t first, int32_t repeats, int32_t interval) {
  Clear(channel);
  Append(channel, {{.y = first}});
  modules_[channel].repeats = repeats;
  modules_[channel].interval = interval;
}

void CompareUnit::Start(size_t channel, double x, double y) {
  CompareModule& module = modules_[channel];
  module.running = true;
  module.hits = 0;
  module.origin_x = x;
  module.origin_y = y;
  if (module.parameters.level_output) SetLevel(channel, module.parameters.start_level);
  // Reserved here, so that a cycle does not allocate.
  log_.reserve(kCompareLogSize);
  edges_.reserve(kHsioEdgesMax);
}

void CompareUnit::Stop(size_t channel) { modules_[channel].running = false; }

void CompareUnit::Clear(size_t channel) {
  CompareModule& module = modules_[channel];
  module.points.clear();
  module.next = 0;
  module.repeats = 0;
}

void CompareUnit::Advance(Micros begin, Micros length, const EncoderWay& way) {
  edges_.clear();
  const auto end = static_cast<double>(begin + length);
  for (size_t i = 0; i < kHsioCount; ++i) {
    // Shows the changes that commands have made since the last cycle.
    Show(i, static_cast<double>(begin));
    AdvanceModule(i, begin, length, way);
    EndPulse(i, end);
  }
}

void CompareUnit::AdvanceModule(size_t channel, Micros begin, Micros length,
                                const EncoderWay& way) {
  CompareModule& module = modules_[channel];
  const CompareParameters& p = module.parameters;
  double fraction = 0;
  while (module.running) {
    const double x0 = way.from[p.x] - module.origin_x;
    const double y0 = way.from[p.y] - module.origin_y;
    const double x1 = way.to[p.x] - module.origin_x;
    const double y1 = way.to[p.y] - module.origin_y;
    fraction = FindHit(x0, y0, x1, y1, p.two_dimensional, module.points[module.next], p.max_error,
                       fraction);
    if (fraction < 0) return;
    Fire(channel, {.channel = static_cast<uint8_t>(channel),
                   .instant = static_cast<double>(begin) + fraction * static_cast<double>(length),
                   .x = Whole(x0 + fraction * (x1 - x0) + module.origin_x),
                   .y = Whole(y0 + fraction * (y1 - y0) + module.origin_y)});
    ++module.hits;
    if (module.repeats > 0) {
      --module.repeats;
      module.points[module.next].y += module.interval;
    } else {
      ++module.next;
    }
    module.running = module.waiting() > 0;
  }
}

void CompareUnit::Fire(size_t channel, const CompareHit& hit) {
  EndPulse(channel, hit.instant);
  HsioOutput& output = outputs_[channel];
  const CompareParameters& p = modules_[channel].parameters;
  if (p.level_output) {
    output.level = !output.level;
  } else {
    output.pulse_end = hit.instant + p.time;
  }
  Show(channel, hit.instant);
  if (log_.size() < kCompareLogSize) log_.push_back(hit);
}

void CompareUnit::EndPulse(size_t channel, double instant) {
  HsioOutput& output = outputs_[channel];
  if (output.pulse_end == 0 || output.pulse_end > instant) return;
  const double end = output.pulse_end;
  output.pulse_end = 0;
  Show(channel, end);
}

void CompareUnit::Show(size_t channel, double instant) {
  HsioOutput& output = outputs_[channel];
  const bool level = output.Level(instant);
  if (level == output.shown) return;
  output.shown = level;
  if (edges_.size() < kHsioEdgesMax) {
    edges_.push_back({static_cast<uint8_t>(channel), level, instant});
  }
}

}  // namespace oncard::motion
