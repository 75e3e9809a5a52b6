#include "runtime/observe/motion_values.h"

#include <fmt/format.h>

#include <array>

namespace oncard::runtime {
namespace {

using motion::MotionCore;

size_t AxisCount(const MotionCore& core) { return core.axis_count(); }

const motion::Axis& AxisAt(const MotionCore& core, size_t index) {
  return core.state().axes[index];
}

template <uint32_t kBit>
double StatusBit(const MotionCore& core, size_t index) {
  return (core.Status(index) & kBit) != 0 ? 1 : 0;
}

constexpr MotionValue Flag(std::string_view name,
                           double (*read)(const MotionCore& core, size_t index)) {
  return {name, NumberForm::kFlag, Unit::kNone, read};
}

constexpr MotionValue kAxisValues[] = {
    {"prfPos", NumberForm::kReal, Unit::kPulse,
     [](const MotionCore& core, size_t i) { return AxisAt(core, i).profile.position; }},
    {"prfVel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const MotionCore& core, size_t i) { return AxisAt(core, i).profile.velocity; }},
    {"prfAcc", NumberForm::kReal, Unit::kPulsePerMs2,
     [](const MotionCore& core, size_t i) { return AxisAt(core, i).profile.acceleration; }},
    {"encPos", NumberForm::kReal, Unit::kPulse,
     [](const MotionCore& core, size_t i) { return AxisAt(core, i).encoder.position; }},
    {"encVel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const MotionCore& core, size_t i) { return AxisAt(core, i).encoder.velocity; }},
    {"encAcc", NumberForm::kReal, Unit::kPulsePerMs2,
     [](const MotionCore& core, size_t i) { return AxisAt(core, i).encoder.acceleration; }},
    {"error", NumberForm::kReal, Unit::kPulse,
     [](const MotionCore& core, size_t i) {
       return AxisAt(core, i).profile.position - AxisAt(core, i).encoder.position;
     }},
    {"sts", NumberForm::kWhole, Unit::kNone,
     [](const MotionCore& core, size_t i) -> double { return core.Status(i); }},
    Flag("alarm", StatusBit<motion::kAlarmBit>),
    Flag("followingError", StatusBit<motion::kFollowingErrorBit>),
    Flag("posLimit", StatusBit<motion::kPositiveLimitBit>),
    Flag("negLimit", StatusBit<motion::kNegativeLimitBit>),
    Flag("smoothStop", StatusBit<motion::kSmoothStopBit>),
    Flag("abruptStop", StatusBit<motion::kAbruptStopBit>),
    Flag("servoOn", StatusBit<motion::kServoOnBit>),
    Flag("moving", StatusBit<motion::kMovingBit>),
    Flag("inPosition", StatusBit<motion::kInPositionBit>),
};

constexpr MotionValue kProfileValues[] = {
    {"pos", NumberForm::kReal, Unit::kPulse,
     [](const MotionCore& core, size_t i) { return core.state().profiles[i].now.position; }},
    {"vel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const MotionCore& core, size_t i) { return core.state().profiles[i].now.velocity; }},
    {"acc", NumberForm::kReal, Unit::kPulsePerMs2,
     [](const MotionCore& core, size_t i) { return core.state().profiles[i].now.acceleration; }},
    {"mode", NumberForm::kWhole, Unit::kNone,
     [](const MotionCore& core, size_t i) {
       return static_cast<double>(core.state().profiles[i].mode);
     }},
};

constexpr MotionValue kEncoderValues[] = {
    {"pos", NumberForm::kReal, Unit::kPulse,
     [](const MotionCore& core, size_t i) { return core.state().encoders[i].position; }},
    {"vel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const MotionCore& core, size_t i) { return core.state().encoders[i].velocity; }},
};

constexpr MotionValue kPlantValues[] = {
    {"pos", NumberForm::kReal, Unit::kPulse,
     [](const MotionCore& core, size_t i) { return core.state().plants[i].position; }},
    {"vel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const MotionCore& core, size_t i) { return core.state().plants[i].velocity; }},
};

size_t CrdCount(const MotionCore& core) { return core.state().crds.size(); }

template <size_t kCoordinate>
double CrdPosition(const MotionCore& core, size_t index) {
  return core.CrdPosition(index)[kCoordinate];
}

constexpr MotionValue kCrdValues[] = {
    {"x", NumberForm::kReal, Unit::kPulse, CrdPosition<0>},
    {"y", NumberForm::kReal, Unit::kPulse, CrdPosition<1>},
    {"z", NumberForm::kReal, Unit::kPulse, CrdPosition<2>},
    {"a", NumberForm::kReal, Unit::kPulse, CrdPosition<3>},
    {"vel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const MotionCore& core, size_t i) { return core.state().crds[i].run.velocity; }},
    Flag("run", [](const MotionCore& core,
                   size_t i) { return core.state().crds[i].run.running ? 1.0 : 0.0; }),
    {"segment", NumberForm::kWhole, Unit::kNone,
     [](const MotionCore& core, size_t i) -> double { return core.state().crds[i].active().done; }},
};

constexpr MotionValue kStepValues[] = {
    {"pos", NumberForm::kReal, Unit::kPulse,
     [](const MotionCore& core, size_t i) { return core.state().steps[i].position; }},
};

constexpr MotionValue kDacValues[] = {
    {"", NumberForm::kWhole, Unit::kNone,
     [](const MotionCore& core, size_t i) -> double { return core.state().dacs[i].Output(); }},
    {"volts", NumberForm::kReal, Unit::kVolt,
     [](const MotionCore& core, size_t i) { return core.state().dacs[i].Volts(); }},
};

constexpr MotionValue kAdcValues[] = {
    {"", NumberForm::kWhole, Unit::kNone,
     [](const MotionCore& core, size_t i) -> double { return core.state().adcs[i].Value(); }},
    {"volts", NumberForm::kReal, Unit::kVolt,
     [](const MotionCore& core, size_t i) { return core.state().adcs[i].Volts(); }},
};

size_t EncoderCount(const MotionCore& core) {
  return core.has_auxiliary() ? motion::kAuxiliaryFirst + motion::kAuxiliaryCount
                              : core.axis_count();
}

constexpr MotionValue kHsioValues[] = {
    Flag("", [](const MotionCore& core,
                size_t i) { return core.state().compare.output(i).Level(core.now()) ? 1.0 : 0.0; }),
};

constexpr std::array kParts = {
    MotionPart{"axis", AxisCount, kAxisValues},
    MotionPart{"profile", AxisCount, kProfileValues},
    MotionPart{"encoder", EncoderCount, kEncoderValues, 1,
               [](const MotionCore& core, size_t i) { return core.HasEncoder(i); }},
    MotionPart{"crd", CrdCount, kCrdValues},
    MotionPart{"plant", AxisCount, kPlantValues},
    MotionPart{"step", AxisCount, kStepValues},
    MotionPart{"dac", AxisCount, kDacValues},
    MotionPart{"adc", [](const MotionCore&) { return motion::kAdcCount; }, kAdcValues},
    MotionPart{kHsioPart, [](const MotionCore&) { return motion::kHsioCount; }, kHsioValues, 0},
};

}  // namespace

std::string_view UnitName(Unit unit) {
  switch (unit) {
    case Unit::kNone:
      break;
    case Unit::kPulse:
      return "pulse";
    case Unit::kPulsePerMs:
      return "pulse/ms";
    case Unit::kPulsePerMs2:
      return "pulse/ms²";
    case Unit::kVolt:
      return "V";
  }
  return {};
}

std::span<const MotionPart> MotionParts() { return kParts; }

const MotionPart* FindMotionPart(std::string_view name) {
  for (const MotionPart& part : kParts) {
    if (part.name == name) return &part;
  }
  return nullptr;
}

const MotionValue* FindMotionValue(const MotionPart& part, std::string_view name) {
  for (const MotionValue& value : part.values) {
    if (value.name == name) return &value;
  }
  return nullptr;
}

std::string MotionValueName(const MotionPart& part, int number, std::string_view value) {
  return fmt::format("{}{}{}{}", part.name, number, value.empty() ? "" : ".", value);
}

}  // namespace oncard::runtime
