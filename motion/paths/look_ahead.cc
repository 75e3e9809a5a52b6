#include "motion/paths/look_ahead.h"

#include <algorithm>
#include <cmath>

#include "motion/common/state_hash.h"
#include "motion/paths/path_limits.h"

namespace oncard::motion {

static_assert(kFieldsComplete<LookAhead> && kFieldsComplete<SpeedChain> &&
              kFieldsComplete<SpeedLink> && kFieldsComplete<PathSlot> &&
              kFieldsComplete<BufferedCommand> && kFieldsComplete<PathApproach>);

void SpeedChain::Push(const SpeedLink& link) {
  back_total = back.empty() ? link : back_total.After(link);
  back.push_back(link);
}

void SpeedChain::Pop() {
  if (front.empty()) {
    for (size_t i = back.size(); i-- > 0;) {
      front.push_back(front.empty() ? back[i] : back[i].After(front.back()));
    }
    back.clear();
  }
  front.pop_back();
}

double SpeedChain::SpeedSquare() const {
  const double behind = back.empty() ? 0 : back_total.At(0);
  return front.empty() ? behind : front.back().At(behind);
}

double LookAhead::CornerBefore(const Coordinates& tangent) const {
  return CornerSpeed(kAllCoordinates, newest_tangent, tangent, acceleration, time);
}

void LookAhead::Push(const PathSlot& pushed) {
  ring.Push(pushed);
  PathSlot& slot = ring.back();
  if (!slot.is_segment) {
    newest_rests = newest_rests || slot.command.NeedsRest();
    return;
  }
  const double radius = slot.segment.radius;
  if (radius > 0) {
    slot.velocity_limit = std::min(slot.velocity_limit, std::sqrt(acceleration * radius));
  }
  const double velocity = std::min(slot.velocity, slot.velocity_limit);
  double junction = 0;
  if (has_newest && !newest_rests) {
    junction = std::min({velocity, newest_velocity, CornerBefore(slot.segment.TangentAt(0))});
  }
  chain.Push({junction * junction, 2 * slot.acceleration * slot.segment.length});
  has_newest = true;
  newest_rests = slot.ends_at_rest;
  newest_velocity = velocity;
  newest_tangent = slot.segment.TangentAt(slot.segment.length);
}

PathSlot LookAhead::Take() {
  PathSlot slot = ring.front();
  ring.Pop();
  if (slot.is_segment) {
    chain.Pop();
    const double reachable = speed * speed + 2 * slot.acceleration * slot.segment.length;
    speed = std::sqrt(std::min(chain.SpeedSquare(), reachable));
    slot.end_velocity = speed;
  }
  if (ring.empty()) {
    has_newest = false;
    newest_rests = false;
  }
  return slot;
}

void LookAhead::Clear() {
  ring.Clear();
  chain = {};
  speed = 0;
  has_newest = false;
  newest_rests = false;
}

}  // namespace oncard::motion
