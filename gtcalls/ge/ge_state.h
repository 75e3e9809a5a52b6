// What a GE card keeps beside its motion core: registers that wait for GT_Update, the command
// register, the samples of watched values. Both families have this state.
#pragma once

#include <array>
#include <cstdint>

#include "gtcalls/ge/limits.h"
#include "gtcalls/ge/path_state.h"
#include "gtcalls/ge/watch.h"
#include "gtcalls/shared/refresh.h"
#include "motion/common/rare.h"

namespace oncard::gtcalls {

/// The registers of an axis that wait for GT_Update.
struct GeRegisters {
  // Motion: PX only.
  Refresh<int32_t> position;
  Refresh<double> velocity;
  Refresh<double> acceleration;
  Refresh<double> max_acceleration;
  Refresh<double> jerk;
  // The servo controller.
  Refresh<double> kp;
  Refresh<double> ki;
  Refresh<double> kd;
  Refresh<double> kvff;
  Refresh<double> kaff;
  Refresh<uint16_t> integral_limit{ge::kServoLimitMax, ge::kServoLimitMax};
  Refresh<uint16_t> output_limit{ge::kServoLimitMax, ge::kServoLimitMax};
  Refresh<int16_t> bias;
  Refresh<uint16_t> error_limit{ge::kServoLimitMax, ge::kServoLimitMax};

  void Update();

  auto Fields(auto visit) const {
    return visit(position, velocity, acceleration, max_acceleration, jerk, kp, ki, kd, kvff, kaff,
                 integral_limit, output_limit, bias, error_limit);
  }
};

struct GeAxis {
  GeRegisters registers;
  bool pulses = false;     ///< GT_CtrlMode(axis, 1) on a card with voltages
  bool open_loop = false;  ///< GT_OpenLp
  bool auto_stop = false;  ///< GT_AuStpOn
  bool stopping = false;   ///< GT_SmthStp has ended the motion in progress, or the last one
  bool refused = false;    ///< an event: a command for this axis has been refused

  auto Fields(auto visit) const {
    return visit(registers, pulses, open_loop, auto_stop, stopping, refused);
  }
};

struct GeState {
  std::array<GeAxis, ge::kAxisMax> axes;
  uint16_t command_register = 0;
  ge::Watch watch;
  motion::Rare<ges::Path> path;  ///< SX

  auto Fields(auto visit) const { return visit(axes, command_register, watch, path); }
};

}  // namespace oncard::gtcalls
