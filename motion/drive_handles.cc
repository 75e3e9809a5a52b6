#include "motion/drive_handles.h"

#include "motion/drive_train.h"
#include "motion/origins.h"

namespace oncard::motion {

// --- Servo controllers -------------------------------------------------------------------------

void ControlHandle::Configure(bool active, int8_t axis, int8_t encoder) const {
  Control& configured = control();
  configured.active = active;
  configured.axis = axis;
  configured.encoder = encoder;
  configured.closed = false;
}

void ControlHandle::SetResponseCheck(int16_t threshold, double min_velocity, Micros time) const {
  ResponseCheck& check = control().check;
  check.threshold = threshold;
  check.min_velocity = min_velocity;
  check.time = time;
}

void ControlHandle::SwitchResponseCheck(bool on) const {
  ResponseCheck& check = control().check;
  check.on = on;
  check.silent = false;
}

// --- Analogue outputs --------------------------------------------------------------------------

void DacHandle::Configure(bool active, bool reversed, int16_t bias, int16_t limit) const {
  dac() = {.active = active, .reversed = reversed, .bias = bias, .limit = limit};
}

void DacHandle::GiveTo(size_t control) const {
  dac().control = static_cast<int8_t>(control);
  core_.state.controls[control].closed = true;
}

// --- Pulse outputs -----------------------------------------------------------------------------

void StepHandle::Configure(bool active, int8_t axis, bool reversed) const {
  Step& step = core_.Changed().steps[index_];
  step.active = active;
  step.axis = axis;
  step.reversed = reversed;
}

// --- Encoders ----------------------------------------------------------------------------------

void EncoderHandle::SetPosition(double position) const {
  Origins(core_.Changed(), core_.config).SetEncoderPosition(index_, position);
}

void EncoderHandle::SetSense(bool reversed) const {
  core_.Changed().encoders[index_].reversed = reversed;
  Rebase();
}

void EncoderHandle::SetExternal(bool external) const {
  core_.Changed().encoders[index_].external = external;
  Rebase();
}

void EncoderHandle::Configure(bool active, bool reversed, bool external) const {
  Encoder& encoder = core_.Changed().encoders[index_];
  encoder.active = active;
  encoder.reversed = reversed;
  encoder.wired_reversed = reversed;
  encoder.external = external;
  Rebase();
}

void EncoderHandle::Rebase() const { DriveTrain(core_.Changed(), core_.config).Rebase(index_); }

}  // namespace oncard::motion
