#include "motion/profiles/pvt_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<PvtTable> && kFieldsComplete<PvtPiece>);

/// A table with only the times and positions of its ends.
PvtTable Frame(std::span<const double> times, std::span<const double> positions) {
  return {times.front(), times.back(), positions.back() - positions.front(), {}};
}

/// Appends the pieces of a velocity change that takes `time` ms; returns the state at its end. The
/// acceleration rises during half of `percent` of the time, is constant, and falls during the other
/// half.
PvtPiece AppendRamp(std::vector<PvtPiece>& pieces, PvtPiece from, double velocity, double time,
                    double percent) {
  const double change = time * percent / 200;
  const double constant = time - 2 * change;
  const double peak = (velocity - from.velocity) / (time - change);
  const bool even = from.velocity == velocity;
  const double jerk = even || change == 0 ? 0 : peak / change;
  struct Phase {
    double duration, acceleration, jerk;
  };
  const std::array<Phase, 3> parts = {{{even ? 0 : change, 0, jerk},
                                       {even ? time : constant, peak, 0},
                                       {even ? 0 : change, peak, -jerk}}};
  for (const Phase& part : parts) {
    if (!(part.duration > 0)) continue;
    from.acceleration = part.acceleration;
    from.jerk = part.jerk;
    pieces.push_back(from);
    const double t = part.duration;
    from.begin += t;
    from.position += t * (from.velocity + t * (part.acceleration / 2 + t * (part.jerk / 6)));
    from.velocity += t * (part.acceleration + t * (part.jerk / 2));
  }
  from.velocity = velocity;
  return from;
}

/// The distance of a velocity change, divided by the difference of the squared velocities.
double RampFactor(double acceleration, double percent) {
  return 1 / (2 * acceleration * (1 - percent / 200));
}

/// One interval of PvtFromLimits, in the direction of its motion.
struct Interval {
  explicit Interval(std::span<const ContinuousRow> rows, size_t i)
      : row(rows[i]),
        sign(rows[i + 1].position < rows[i].position ? -1 : 1),
        distance(sign * (rows[i + 1].position - rows[i].position)),
        begin(sign * rows[i].velocity),
        end(sign * rows[i + 1].velocity) {
    const double up = RampFactor(row.acceleration, row.percent);
    const double down = RampFactor(row.deceleration, row.percent);
    reachable = std::sqrt((distance + up * begin * begin + down * end * end) / (up + down));
    top = std::min(row.velocity_max, reachable);
    up_time = 2 * up * (top - begin);
    down_time = 2 * down * (top - end);
    const double rest =
        distance - up * (top * top - begin * begin) - down * (top * top - end * end);
    even_time = top > 0 && top < reachable ? rest / top : 0;
  }

  bool Possible() const {
    const double fastest = std::max(begin, end);
    return distance > 0 && begin >= 0 && end >= 0 && fastest <= row.velocity_max &&
           fastest <= reachable * (1 + kRounding) && duration() >= kPvtIntervalMin;
  }
  double duration() const {
    return std::max(up_time, 0.0) + std::max(even_time, 0.0) + std::max(down_time, 0.0);
  }

  /// Rounding must not make a velocity impossible that can just be reached.
  static constexpr double kRounding = 1e-12;

  const ContinuousRow& row;
  double sign;
  double distance;
  double begin;
  double end;
  double reachable;  ///< the peak velocity if no distance is left for constant velocity
  double top;
  double up_time;
  double even_time;
  double down_time;
};

}  // namespace

double PvtTable::Direction() const {
  for (const PvtPiece& piece : pieces) {
    for (const double derivative : {piece.velocity, piece.acceleration, piece.jerk}) {
      if (derivative != 0) return derivative;
    }
  }
  return 0;
}

Sample PvtTable::At(double t) const {
  if (pieces.empty() || t < begin) return {0, 0, 0, true};
  const auto after =
      std::upper_bound(pieces.begin(), pieces.end(), t,
                       [](double time, const PvtPiece& piece) { return time < piece.begin; });
  const PvtPiece& piece = *std::prev(after);
  const double d = t - piece.begin;
  return {
      piece.position + d * (piece.velocity + d * (piece.acceleration / 2 + d * (piece.jerk / 6))),
      piece.velocity + d * (piece.acceleration + d * (piece.jerk / 2)),
      piece.acceleration + d * piece.jerk, true};
}

PvtTable PvtFromCubics(std::span<const double> times, std::span<const double> positions,
                       std::span<const CubicCoefficients> cubics) {
  PvtTable table = Frame(times, positions);
  for (size_t i = 0; i + 1 < times.size(); ++i) {
    const CubicCoefficients& cubic = cubics[i];
    table.pieces.push_back(
        {times[i], positions[i] - positions[0], cubic.c, 2 * cubic.b, 6 * cubic.a});
  }
  return table;
}

PvtTable PvtFromVelocities(std::span<const double> times, std::span<const double> positions,
                           std::span<const double> begin_velocities,
                           std::span<const double> end_velocities) {
  std::vector<CubicCoefficients> cubics(times.size());
  for (size_t i = 0; i + 1 < times.size(); ++i) {
    const double t = times[i + 1] - times[i];
    const double mean = (positions[i + 1] - positions[i]) / t;
    const double v0 = begin_velocities[i];
    const double v1 = end_velocities[i + 1];
    cubics[i] = {(v0 + v1 - 2 * mean) / t / t, (3 * mean - 2 * v0 - v1) / t, v0};
  }
  return PvtFromCubics(times, positions, cubics);
}

std::vector<CubicCoefficients> SplineCoefficients(std::span<const double> times,
                                                  std::span<const double> positions,
                                                  double begin_velocity, double end_velocity) {
  const size_t count = times.size();
  std::vector<double> velocities(count, begin_velocity);
  velocities.back() = count > 1 ? end_velocity : begin_velocity;
  // Equal accelerations on both sides of every inner point: a tridiagonal system for the
  // velocities. Its rows are eliminated downwards; `upper` is what remains to the right of the
  // diagonal.
  std::vector<double> upper(count, 0);
  for (size_t i = 1; i + 1 < count; ++i) {
    const double before = 1 / (times[i] - times[i - 1]);
    const double after = 1 / (times[i + 1] - times[i]);
    const double right = 3 * ((positions[i] - positions[i - 1]) * before * before +
                              (positions[i + 1] - positions[i]) * after * after);
    const double diagonal = 2 * (before + after) - before * upper[i - 1];
    upper[i] = after / diagonal;
    velocities[i] = (right - before * velocities[i - 1]) / diagonal;
  }
  for (size_t i = count - 1; i-- > 1;) velocities[i] -= upper[i] * velocities[i + 1];

  std::vector<CubicCoefficients> cubics(count);
  for (size_t i = 0; i + 1 < count; ++i) {
    const double t = times[i + 1] - times[i];
    const double mean = (positions[i + 1] - positions[i]) / t;
    cubics[i] = {(velocities[i] + velocities[i + 1] - 2 * mean) / t / t,
                 (3 * mean - 2 * velocities[i] - velocities[i + 1]) / t, velocities[i]};
    cubics[i + 1].b = cubics[i].b + 3 * cubics[i].a * t;
  }
  cubics.back().c = velocities.back();
  return cubics;
}

std::vector<double> PercentVelocities(std::span<const double> times,
                                      std::span<const double> positions, double begin_velocity) {
  std::vector<double> velocities = {begin_velocity};
  for (size_t i = 0; i + 1 < times.size(); ++i) {
    velocities.push_back(2 * (positions[i + 1] - positions[i]) / (times[i + 1] - times[i]) -
                         velocities.back());
  }
  return velocities;
}

PvtTable PvtFromPercents(std::span<const double> times, std::span<const double> positions,
                         std::span<const double> percents, double begin_velocity) {
  PvtTable table = Frame(times, positions);
  const std::vector<double> velocities = PercentVelocities(times, positions, begin_velocity);
  for (size_t i = 0; i + 1 < times.size(); ++i) {
    AppendRamp(table.pieces, {times[i], positions[i] - positions[0], velocities[i], 0, 0},
               velocities[i + 1], times[i + 1] - times[i], percents[i]);
  }
  return table;
}

size_t FirstImpossibleInterval(std::span<const ContinuousRow> rows) {
  for (size_t i = 0; i + 1 < rows.size(); ++i) {
    if (!Interval(rows, i).Possible()) return i;
  }
  return rows.size() - 1;
}

PvtTable PvtFromLimits(std::span<const ContinuousRow> rows, double begin_time) {
  PvtTable table;
  table.begin = begin_time;
  table.travel = rows.back().position - rows.front().position;
  double time = begin_time;
  for (size_t i = 0; i + 1 < rows.size(); ++i) {
    const Interval interval(rows, i);
    PvtPiece from = {time, rows[i].position - rows[0].position, rows[i].velocity, 0, 0};
    const double top = interval.sign * interval.top;
    if (interval.up_time > 0) {
      from = AppendRamp(table.pieces, from, top, interval.up_time, interval.row.percent);
    }
    if (interval.even_time > 0) {
      from = AppendRamp(table.pieces, from, from.velocity, interval.even_time, 0);
    }
    if (interval.down_time > 0) {
      AppendRamp(table.pieces, from, rows[i + 1].velocity, interval.down_time,
                 interval.row.percent);
    }
    time += interval.duration();
  }
  table.end = time;
  return table;
}

std::vector<double> ContinuousTimes(std::span<const ContinuousRow> rows) {
  std::vector<double> times = {0};
  for (size_t i = 0; i + 1 < rows.size(); ++i) {
    times.push_back(times.back() + Interval(rows, i).duration());
  }
  return times;
}

}  // namespace oncard::motion
