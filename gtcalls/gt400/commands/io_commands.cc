// Inputs, outputs and auxiliary encoders. Source: GT manual chapters 9 and 11; public header.
// Tested by tests/gtcalls/gt400/io_command_test.cc.
#include <algorithm>
#include <cmath>

#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/shared/io_commands.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::Capture;
using motion::CaptureSource;
using motion::kAuxiliaryFirst;
using motion::MotionState;

/// The auxiliary encoder that the first argument numbers.
size_t AuxiliaryOf(const Call& call) {
  return kAuxiliaryFirst + static_cast<size_t>(call.integer(0)) - 1;
}

int16_t CheckAuxiliaryEncoders(Call& call) {
  if (call.card.motion.has_auxiliary()) return vm::kOk;
  return RefuseFor(call, kIllegal,
                   {"the card has no auxiliary encoders; the SV, SG and SP cards have them",
                    "本控制卡没有辅助编码器；SV、SG 和 SP 卡才有"});
}

const Capture& AuxiliaryCapture(const Call& call, size_t encoder) {
  return call.card.motion.part<&MotionState::capture>().capture(kAuxiliaryFirst + encoder);
}

/// What the converter makes of a voltage: a sign and 2048 steps for 10 V.
double Converted(double volts) {
  constexpr double kStepsPerVolt = 204.8;
  constexpr double kLargest = 2047;
  constexpr double kSign = 2048;
  const double magnitude = std::min(motion::Whole(std::fabs(volts) * kStepsPerVolt), kLargest);
  return volts < 0 ? kSign + magnitude : magnitude;
}

}  // namespace

int16_t GT_ExInpt(Call& call) { return ReadGeneralInputs(call); }
int16_t GT_ExOpt(Call& call) { return WriteGeneralOutputs(call); }
int16_t GT_ExOptBit(Call& call) { return WriteGeneralOutput(call); }
int16_t GT_GetExOpt(Call& call) { return ReadGeneralOutputs(call); }
int16_t GT_GetLmtSwt(Call& call) { return ReadLimitLevels(call); }
int16_t GT_GetHomeSwt(Call& call) { return ReadHomeLevels(call); }

int16_t GT_GetAdc(Call& call) {
  const int channel = call.integer(0);
  const auto index = static_cast<size_t>(channel - 1);
  const double volts = call.card.motion.part<&MotionState::adcs>()[index].volts;
  call.Set(1, channel <= StateOf(call).adc_channels ? Converted(volts) : 0);
  return vm::kOk;
}

int16_t GT_SetAdcChn(Call& call) {
  StateOf(call).adc_channels = static_cast<uint8_t>(call.integer(0));
  return vm::kOk;
}

int16_t GT_EncPos(Call& call) {
  const int16_t code = CheckAuxiliaryEncoders(call);
  if (code == vm::kOk) call.Set(1, call.card.motion.encoder(AuxiliaryOf(call)).position);
  return code;
}

int16_t GT_EncVel(Call& call) {
  const int16_t code = CheckAuxiliaryEncoders(call);
  if (code == vm::kOk) call.Set(1, call.card.motion.encoder(AuxiliaryOf(call)).velocity);
  return code;
}

int16_t GT_ClrEncPos(Call& call) {
  call.card.motion.EncoderAt(AuxiliaryOf(call)).SetPosition(0);
  return vm::kOk;
}

int16_t GT_SetEncCapt(Call& call) {
  call.card.motion.capture().Arm(kAuxiliaryFirst, CaptureSource::kIndex);
  return vm::kOk;
}

int16_t GT_GetEncCapt(Call& call) {
  call.Set(0, motion::Whole(AuxiliaryCapture(call, 0).value));
  return vm::kOk;
}

namespace {

/// The bit that says of an auxiliary encoder that it has been latched.
constexpr uint32_t kLatchedBit = 1u << 3;
/// Assumption: the second encoder has the upper half of the long status.
constexpr uint32_t kLatchedBitOfSecond = 1u << 19;

uint32_t LatchedBits(const Call& call) {
  return (AuxiliaryCapture(call, 0).captured ? kLatchedBit : 0) |
         (AuxiliaryCapture(call, 1).captured ? kLatchedBitOfSecond : 0);
}

}  // namespace

int16_t GT_GetEncSts(Call& call) {
  call.Set(0, LatchedBits(call) & kLatchedBit);
  return vm::kOk;
}

int16_t GT_GetEncStsEx(Call& call) {
  call.Set(0, LatchedBits(call));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gt400
