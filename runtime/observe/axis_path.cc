#include "runtime/observe/axis_path.h"

#include <utility>

#include "motion/paths/path_ahead.h"

namespace oncard::runtime {
namespace {

/// Where the position of a profile puts the axis of its number.
double AxisPlace(const Controller& controller, size_t axis, double position) {
  const motion::Axis& its = controller.motion().state().axes[axis];
  const double pulses = its.profile_scale.Apply(position) + its.profile.offset;
  return controller.options().units[axis].FromPulses(pulses, AxisMeasure::kPosition);
}

}  // namespace

AxisPath PathAhead(const Controller& controller, size_t crd, size_t most) {
  const motion::MotionCore& core = controller.motion();
  const motion::PathAhead ahead =
      motion::FindPathAhead(core.state().crds[crd], core.CrdPosition(crd), most);
  AxisPath path;
  path.whole = ahead.whole;
  for (const size_t profile : ahead.profiles) path.axes.push_back(profile + 1);
  for (const std::vector<double>& positions : ahead.points) {
    std::vector<double> places;
    for (size_t i = 0; i < positions.size(); ++i) {
      places.push_back(AxisPlace(controller, ahead.profiles[i], positions[i]));
    }
    path.points.push_back(std::move(places));
  }
  return path;
}

}  // namespace oncard::runtime
