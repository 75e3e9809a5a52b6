#include "motion/crd_port.h"

#include <array>

#include "motion/origins.h"
#include "motion/readings.h"

namespace oncard::motion {
namespace {

void CarryOutLaser(const BufferedCommand& command, Laser* laser) {
  switch (command.kind) {
    case BufferedKind::kLaserSwitch:
      laser->on = command.detail != 0;
      break;
    case BufferedKind::kLaserPower:
      laser->power = command.values[0];
      laser->follows = false;
      break;
    case BufferedKind::kLaserFollow:
      laser->follows = true;
      laser->crd = static_cast<uint8_t>(command.detail);
      laser->ratio = command.values[0];
      laser->follow_bounds = {command.values[1], command.values[2]};
      break;
    case BufferedKind::kLaserSource:
      laser->source = static_cast<LaserSource>(command.detail);
      break;
    default:
      break;
  }
}

}  // namespace

void CrdPort::TellDriveOff(int32_t profile) const {
  if (!observer_) return;
  const auto axis = Readings(state_, config_).AxisWithDriveOff(static_cast<size_t>(profile));
  if (axis) observer_({CardEventKind::kMovedByPath, *axis, 0, static_cast<double>(index_)});
}

void CrdPort::CarryOut(const BufferedCommand& command) {
  block_.Leave();
  const auto item = static_cast<size_t>(command.item);
  const std::array<double, 4>& values = command.values;
  switch (command.kind) {
    case BufferedKind::kDelay:
    case BufferedKind::kHold:
    case BufferedKind::kMove:
    case BufferedKind::kGear:
      break;
    case BufferedKind::kOutputs:
      state_.io.Write(static_cast<DoType>(command.item), static_cast<uint32_t>(values[0]),
                      static_cast<uint32_t>(values[1]));
      break;
    case BufferedKind::kPulses:
      state_.io.StartPulses(static_cast<DoType>(command.item), command.detail,
                            static_cast<int64_t>(values[0]), static_cast<int64_t>(values[1]),
                            static_cast<int64_t>(values[2]), values[3] != 0);
      break;
    case BufferedKind::kStopPulses:
      state_.io.StopTiming(static_cast<DoType>(command.item), command.detail);
      break;
    case BufferedKind::kAnalogOutput:
      if (state_.dacs[item].control < 0) state_.dacs[item].value = values[0];
      break;
    case BufferedKind::kLimits:
      if (command.detail != 1) state_.axes[item].positive_limit_on = values[0] != 0;
      if (command.detail != 0) state_.axes[item].negative_limit_on = values[0] != 0;
      break;
    case BufferedKind::kStopInput: {
      Axis& axis = state_.axes[item];
      (command.detail != 0 ? axis.abrupt_stop : axis.smooth_stop) = {
          static_cast<DiType>(values[0]), static_cast<int16_t>(values[1])};
      break;
    }
    case BufferedKind::kSynchronise:
      if (state_.profiles[item].now.moving) break;
      Origins(state_, config_)
          .SetProfilePosition(item, state_.encoders[static_cast<size_t>(command.detail)].position);
      break;
    case BufferedKind::kComparePulse:
      for (size_t channel = 0; channel < kHsioCount; ++channel) {
        if (command.item != 0) {
          state_.compare.SetLevel(channel, values[0] != 0);
        } else {
          state_.compare.Pulse(channel, now(), static_cast<int16_t>(values[1]));
        }
      }
      break;
    case BufferedKind::kLaserSwitch:
    case BufferedKind::kLaserPower:
    case BufferedKind::kLaserFollow:
    case BufferedKind::kLaserSource:
      CarryOutLaser(command, &state_.lasers.channels[item]);
      break;
    case BufferedKind::kOutside:
      state_.reached.push_back(command);
      break;
  }
}

}  // namespace oncard::motion
