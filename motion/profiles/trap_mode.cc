#include "motion/profiles/trap_mode.h"

#include <algorithm>
#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<TrapMode> && kFieldsComplete<TrapParameters>);

/// The integral of a piece's position, relative to `base`, from `a` to `b` ms after its beginning.
double Integral(const Piece& piece, double base, double a, double b) {
  const double first = piece.PositionAt(a);
  const double velocity = piece.VelocityAt(a);
  const double t = b - a;
  return t * ((first - base) + t * (velocity / 2 + t * (piece.acceleration / 6)));
}

/// The planned motion before averaging: the past, the pieces, and rest at the end.
class Raw {
 public:
  explicit Raw(const TrapMode& mode) : mode_(mode) {
    for (const Piece& piece : mode.past) past_ += piece.duration;
  }

  /// The integral of position - base over [from, to], in ms after the beginning of the plan.
  double IntegralOver(double from, double to, double base) const {
    double sum = 0;
    double begin = -past_;
    const Piece& first = mode_.past.empty() ? mode_.plan.pieces[0] : mode_.past.front();
    if (from < begin) {
      // Rest before the first piece.
      sum += (std::min(to, begin) - from) * (first.position - base);
    }
    const auto add = [&](const Piece& piece) {
      const double a = std::max(from, begin);
      const double b = std::min(to, begin + piece.duration);
      if (b > a) sum += Integral(piece, base, a - begin, b - begin);
      begin += piece.duration;
    };
    for (const Piece& piece : mode_.past) add(piece);
    for (uint32_t i = 0; i < mode_.plan.count; ++i) add(mode_.plan.pieces[i]);
    if (to > begin) sum += (to - std::max(from, begin)) * (mode_.plan.end_position - base);
    return sum;
  }

  /// Position and velocity `t` ms after the beginning of the plan; `t` may be negative.
  Sample At(double t) const {
    if (t >= 0) return mode_.plan.At(t);
    double begin = -past_;
    for (const Piece& piece : mode_.past) {
      if (t < begin) return AtRest(piece.position);
      if (t < begin + piece.duration) {
        return {piece.PositionAt(t - begin), piece.VelocityAt(t - begin), piece.acceleration, true};
      }
      begin += piece.duration;
    }
    return mode_.past.empty() ? AtRest(mode_.plan.pieces[0].position) : mode_.plan.At(0);
  }

 private:
  const TrapMode& mode_;
  double past_ = 0;
};

/// Moves what the plan has done in `elapsed` ms to the past, and removes what the mean no longer
/// needs.
void KeepPast(double elapsed, TrapMode* mode) {
  double left = elapsed;
  for (uint32_t i = 0; i < mode->plan.count && left > 0; ++i) {
    Piece piece = mode->plan.pieces[i];
    piece.duration = std::min(piece.duration, left);
    left -= piece.duration;
    mode->past.push_back(piece);
  }
  if (left > 0) mode->past.push_back({left, mode->plan.end_position, 0, 0});
  double kept = 0;
  size_t needed = mode->past.size();
  while (needed > 0 && kept < mode->smooth) kept += mode->past[--needed].duration;
  mode->past.erase(mode->past.begin(), mode->past.begin() + static_cast<std::ptrdiff_t>(needed));
}

}  // namespace

void TrapMode::Start(Micros now, const Sample& from) {
  Sample raw = from;
  if (!running) {
    past.clear();
    smooth = parameters.smooth_time;
    if (smooth > 0 && from.velocity != 0) {
      // After a stop: the mean continues as if the velocity had been constant until now.
      const double half = from.velocity * smooth / 2;
      past.push_back({smooth, from.position - half, from.velocity, 0});
      raw.position += half;
    }
  } else if (now > begin) {
    const double elapsed = MsBetween(begin, now);
    raw = plan.At(elapsed);
    if (smooth > 0) KeepPast(elapsed, this);
  } else {
    raw = unplanned;
  }
  unplanned = raw;
  plan = PlanToPosition(raw.position, raw.velocity, target,
                        {PlannedVelocityOf(std::fabs(velocity)), parameters.acc,
                         DecelerationOf(parameters.acc, parameters.dec), parameters.vel_start});
  begin = now;
  running = plan.count > 0 || !past.empty();
}

Sample TrapMode::At(Micros now) {
  const double t = MsBetween(begin, now);
  if (t >= plan.duration + smooth) {
    running = false;
    past.clear();
    return AtRest(plan.end_position);
  }
  if (smooth == 0) return plan.At(t);
  const Raw raw(*this);
  const Sample head = raw.At(t);
  const Sample tail = raw.At(t - smooth);
  const double base = head.position;
  return {base + raw.IntegralOver(t - smooth, t, base) / smooth,
          (head.position - tail.position) / smooth, (head.velocity - tail.velocity) / smooth, true};
}

void TrapMode::ForgetRun() {
  if (running) return;
  plan = {};
  unplanned = {};
  begin = 0;
  smooth = 0;
  past.clear();
}

void TrapMode::Halt() {
  running = false;
  past.clear();
}

}  // namespace oncard::motion
