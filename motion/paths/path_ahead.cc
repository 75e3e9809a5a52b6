#include "motion/paths/path_ahead.h"

#include <algorithm>
#include <cmath>

namespace oncard::motion {
namespace {

/// The first points of a way.
class Way {
 public:
  Way(const Coordinates& begin, size_t most) : most_(most), points_{begin} {}

  const std::vector<Coordinates>& points() const { return points_; }
  /// False if a point has found no place.
  bool whole() const { return whole_; }

  void AddSegment(const Segment& segment, double from = 0) {
    const double rest = segment.length - from;
    const double angle = segment.sweep * rest / segment.length;
    const int chords = std::max(1, static_cast<int>(std::ceil(angle / kChordAngle)));
    for (int i = 0; i < chords && whole_; ++i) AddPoint(segment.PointAt(from + rest * i / chords));
    AddPoint(segment.end);
  }

  void AddWaiting(const PathSlot& slot) {
    if (slot.approach.in_use()) {
      AddPoint(slot.ApproachEnd(points_.back()));
    } else {
      AddSegment(slot.segment);
    }
  }

 private:
  void AddPoint(const Coordinates& point) {
    if (point == points_.back()) return;
    whole_ = points_.size() < most_;
    if (whole_) points_.push_back(point);
  }

  size_t most_;
  std::vector<Coordinates> points_;
  bool whole_ = true;
};

Way WayOf(const Crd& crd, const Coordinates& here, size_t most) {
  const CrdFifo& fifo = crd.active();
  Way way(here, most);
  if (fifo.executing) way.AddSegment(fifo.current.segment, fifo.path);
  if (fifo.interruption && fifo.interruption->executing) {
    way.AddSegment(fifo.interruption->slot.segment, fifo.interruption->path);
  }
  for (size_t i = 0; i < fifo.slots.size() && way.whole(); ++i) {
    if (fifo.slots.At(i).is_segment) way.AddWaiting(fifo.slots.At(i));
  }
  return way;
}

std::vector<size_t> ProfilesOf(const Crd& crd) {
  std::vector<size_t> profiles;
  if (crd.map) {
    for (size_t axis = 0; axis < kMappedAxisMax; ++axis) {
      if (crd.map->Has(axis)) profiles.push_back(axis);
    }
  } else {
    for (size_t i = 0; i < crd.dimension(); ++i) {
      profiles.push_back(static_cast<size_t>(crd.members[i]));
    }
  }
  return profiles;
}

std::vector<double> PositionsAt(const Coordinates& point, const Crd& crd,
                                const std::vector<size_t>& profiles) {
  std::vector<double> positions;
  for (size_t i = 0; i < profiles.size(); ++i) {
    positions.push_back(crd.map ? crd.map->PositionOf(profiles[i], point)
                                : crd.origin[i] + point[i]);
  }
  return positions;
}

}  // namespace

PathAhead FindPathAhead(const Crd& crd, const Coordinates& here, size_t most) {
  const Way way = WayOf(crd, here, most);
  PathAhead ahead;
  ahead.profiles = ProfilesOf(crd);
  ahead.whole = way.whole();
  // A point alone is no path.
  if (way.points().size() == 1) return ahead;
  for (const Coordinates& point : way.points()) {
    ahead.points.push_back(PositionsAt(point, crd, ahead.profiles));
  }
  return ahead;
}

}  // namespace oncard::motion
