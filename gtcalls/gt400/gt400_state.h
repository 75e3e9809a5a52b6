// What a GT400 card keeps beside its motion core: the registers of its axes that wait for an
// Update, and the valid ones; events; the current axis; the command register; its path and its
// interrupts.
#pragma once

#include <array>
#include <cstdint>

#include "gtcalls/gt400/interrupt_unit.h"
#include "gtcalls/gt400/limits.h"
#include "gtcalls/gt400/path_state.h"
#include "motion/common/rare.h"

namespace oncard::gtcalls {
namespace gt400 {

/// The registers of an axis that take effect together, with an Update (registers.def).
struct AxisRegisters {
  int32_t position = 0;         ///< target of modes T and S, pulses
  double velocity = 0;          ///< pulse/ST
  double acceleration = 0;      ///< of modes T and V, pulse/ST^2
  double max_acceleration = 0;  ///< of mode S
  double jerk = 0;              ///< the same, pulse/ST^3
  double ratio = 0;             ///< of the gear: slave to master
  int32_t breakpoint = 0;       ///< pulses
  double kp = 0;
  double ki = 0;
  double kd = 0;
  double kvff = 0;
  double kaff = 0;
  uint16_t integral_limit = kServoMax;
  uint16_t output_limit = kServoMax;
  int16_t bias = 0;
  uint16_t error_limit = kServoMax;  ///< pulses

  auto Fields(auto visit) const {
    return visit(position, velocity, acceleration, max_acceleration, jerk, ratio, breakpoint, kp,
                 ki, kd, kvff, kaff, integral_limit, output_limit, bias, error_limit);
  }
};

/// What an Update does besides making registers valid.
struct UpdateRequest {
  uint16_t written = 0;         ///< the registers that have been written since the last Update
  bool smooth_stop = false;     ///< GT_SmthStp
  bool synch_position = false;  ///< GT_SynchPos

  auto Fields(auto visit) const { return visit(written, smooth_stop, synch_position); }
};

/// An Update that takes effect at the next tick.
struct TakenUpdate {
  AxisRegisters registers;
  UpdateRequest request;

  auto Fields(auto visit) const { return visit(registers, request); }
};

/// A GT_Home that begins at the next tick.
struct TakenHoming {
  int32_t bound = 0;  ///< where the search ends

  auto Fields(auto visit) const { return visit(bound); }
};

/// What an axis waits for at a breakpoint.
enum class Breakpoint : uint8_t {
  kNone,
  kPositive,  ///< the actual position is at its register or above
  kNegative,  ///< at its register or below
  kMotion,    ///< a motion ends
  kCapture,   ///< a position is captured
};

struct Gt400Axis {
  AxisRegisters waiting;  ///< as last written; what commands read
  AxisRegisters valid;    ///< in use
  UpdateRequest request;  ///< what waits with them
  motion::Rare<TakenUpdate> taken;
  motion::Rare<TakenHoming> taken_homing;
  uint8_t events = 0;        ///< bits 0 to 7 of the status word
  uint8_t new_events = 0;    ///< those that have occurred since the last tick
  uint32_t noticed = 0;      ///< conditions whose present causes are among the events, or were
  bool moved = false;        ///< it moved after the last tick or command
  bool pulses = false;       ///< GT_CtrlMode(1) on a card with voltages
  bool open_loop = false;    ///< GT_OpenLp
  int16_t open_output = 0;   ///< GT_SetMtrCmd: the output in open loop
  bool auto_stop = false;    ///< GT_AuStpOn
  bool auto_update = false;  ///< GT_AuUpdtOn
  Breakpoint breakpoint = Breakpoint::kNone;
  bool homes_to_index = false;  ///< GT_Index

  auto Fields(auto visit) const {
    return visit(waiting, valid, request, taken, taken_homing, events, new_events, noticed, moved,
                 pulses, open_loop, open_output, auto_stop, auto_update, breakpoint,
                 homes_to_index);
  }
};

}  // namespace gt400

struct Gt400State {
  std::array<gt400::Gt400Axis, gt400::kAxisMax> axes;
  uint8_t current = 0;  ///< the axis that commands mean
  double sample_time = gt400::kSampleTime;
  uint16_t command_register = 0;
  bool path_refused = false;              ///< the last path command
  uint8_t adc_channels = gt400::kAdcMax;  ///< GT_SetAdcChn: those that are converted
  bool probe_stops = false;               ///< GT_ProbStopOn
  gt400::Path path;
  gt400::InterruptUnit interrupts;

  auto Fields(auto visit) const {
    return visit(axes, current, sample_time, command_register, path_refused, adc_channels,
                 probe_stops, path, interrupts);
  }

  /// GT_Reset.
  void Reset();
};

}  // namespace oncard::gtcalls
