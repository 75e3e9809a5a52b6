#include "motion/crd_port.h"

#include <array>

#include "motion/origins.h"

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

void CrdPort::TellDriveOff(CardEventKind kind, int32_t profile) const {
  if (!observed()) return;
  const auto axis = core_.readings().AxisWithDriveOff(static_cast<size_t>(profile));
  if (axis) core_.observer({kind, *axis, 0, static_cast<double>(index_)});
}

void CrdPort::CarryOut(const BufferedCommand& command) {
  MotionState& state = core_.Changed();
  const auto item = static_cast<size_t>(command.item);
  const std::array<double, 4>& values = command.values;
  switch (command.kind) {
    case BufferedKind::kDelay:
    case BufferedKind::kHold:
    case BufferedKind::kMove:
    case BufferedKind::kGear:
      break;
    case BufferedKind::kOutputs:
      state.io.Write(static_cast<DoType>(command.item), static_cast<uint32_t>(values[0]),
                     static_cast<uint32_t>(values[1]));
      break;
    case BufferedKind::kPulses:
      state.io.StartPulses(static_cast<DoType>(command.item), command.detail,
                           static_cast<int64_t>(values[0]), static_cast<int64_t>(values[1]),
                           static_cast<int64_t>(values[2]), values[3] != 0);
      break;
    case BufferedKind::kStopPulses:
      state.io.StopTiming(static_cast<DoType>(command.item), command.detail);
      break;
    case BufferedKind::kAnalogOutput:
      if (state.dacs[item].control < 0) state.dacs[item].value = values[0];
      break;
    case BufferedKind::kLimits:
      if (command.detail != 1) state.axes[item].positive_limit_on = values[0] != 0;
      if (command.detail != 0) state.axes[item].negative_limit_on = values[0] != 0;
      break;
    case BufferedKind::kStopInput: {
      Axis& axis = state.axes[item];
      (command.detail != 0 ? axis.abrupt_stop : axis.smooth_stop) = {
          static_cast<DiType>(values[0]), static_cast<int16_t>(values[1])};
      break;
    }
    case BufferedKind::kSynchronise:
      if (state.profiles[item].now.moving) break;
      Origins(state, core_.config)
          .SetProfilePosition(item, state.encoders[static_cast<size_t>(command.detail)].position);
      break;
    case BufferedKind::kComparePulse:
      for (size_t channel = 0; channel < kHsioCount; ++channel) {
        if (command.item != 0) {
          state.compare.SetLevel(channel, values[0] != 0);
        } else {
          state.compare.Pulse(channel, now(), static_cast<int16_t>(values[1]));
        }
      }
      break;
    case BufferedKind::kLaserSwitch:
    case BufferedKind::kLaserPower:
    case BufferedKind::kLaserFollow:
    case BufferedKind::kLaserSource:
      CarryOutLaser(command, &state.lasers.channels[item]);
      break;
    case BufferedKind::kOutside:
      state.reached.push_back(command);
      break;
  }
}

}  // namespace oncard::motion
