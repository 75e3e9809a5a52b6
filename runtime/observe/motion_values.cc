#include "runtime/observe/motion_values.h"

#include <fmt/core.h>

#include <array>

namespace oncard::runtime {
namespace {

using gtcalls::CardView;
using motion::MotionCore;

size_t AxisCount(const MotionCore& core) { return core.axis_count(); }

const motion::Axis& AxisAt(const CardView& card, size_t index) {
  return card.motion.state().axes[index];
}

/// For conditions that come and go with the state of the axis.
template <uint32_t kBit>
double HasCondition(const CardView& card, size_t index) {
  return (card.motion.Conditions(index) & kBit) != 0 ? 1 : 0;
}

/// For conditions that stay until GT_ClrSts.
template <uint32_t kBit>
double HasLatched(const CardView& card, size_t index) {
  return (AxisAt(card, index).latched & kBit) != 0 ? 1 : 0;
}

constexpr MotionValue Flag(std::string_view name,
                           double (*read)(const CardView& card, size_t index)) {
  return {name, NumberForm::kFlag, Unit::kNone, read};
}

constexpr MotionValue kAxisValues[] = {
    {"prfPos", NumberForm::kReal, Unit::kPulse,
     [](const CardView& card, size_t i) { return AxisAt(card, i).profile.position; }},
    {"prfVel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const CardView& card, size_t i) { return AxisAt(card, i).profile.velocity; }},
    {"prfAcc", NumberForm::kReal, Unit::kPulsePerMs2,
     [](const CardView& card, size_t i) { return AxisAt(card, i).profile.acceleration; }},
    {"encPos", NumberForm::kReal, Unit::kPulse,
     [](const CardView& card, size_t i) { return AxisAt(card, i).encoder.position; }},
    {"encVel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const CardView& card, size_t i) { return AxisAt(card, i).encoder.velocity; }},
    {"encAcc", NumberForm::kReal, Unit::kPulsePerMs2,
     [](const CardView& card, size_t i) { return AxisAt(card, i).encoder.acceleration; }},
    {"error", NumberForm::kReal, Unit::kPulse,
     [](const CardView& card, size_t i) {
       return AxisAt(card, i).profile.position - AxisAt(card, i).encoder.position;
     }},
    {"sts", NumberForm::kWhole, Unit::kNone,
     [](const CardView& card, size_t i) -> double { return card.StatusWord(i); }},
    Flag("alarm", HasLatched<motion::kAlarmBit>),
    Flag("followingError", HasLatched<motion::kFollowingErrorBit>),
    Flag("posLimit", HasLatched<motion::kPositiveLimitBit>),
    Flag("negLimit", HasLatched<motion::kNegativeLimitBit>),
    Flag("smoothStop", HasLatched<motion::kSmoothStopBit>),
    Flag("abruptStop", HasLatched<motion::kAbruptStopBit>),
    Flag("servoOn", HasCondition<motion::kServoOnBit>),
    Flag("moving", HasCondition<motion::kMovingBit>),
    Flag("inPosition", HasCondition<motion::kInPositionBit>),
};

constexpr MotionValue kProfileValues[] = {
    {"pos", NumberForm::kReal, Unit::kPulse,
     [](const CardView& card, size_t i) { return card.motion.state().profiles[i].now.position; }},
    {"vel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const CardView& card, size_t i) { return card.motion.state().profiles[i].now.velocity; }},
    {"acc", NumberForm::kReal, Unit::kPulsePerMs2,
     [](const CardView& card, size_t i) {
       return card.motion.state().profiles[i].now.acceleration;
     }},
    {"mode", NumberForm::kWhole, Unit::kNone,
     [](const CardView& card, size_t i) -> double { return card.ModeNumber(i); }},
};

constexpr MotionValue kEncoderValues[] = {
    {"pos", NumberForm::kReal, Unit::kPulse,
     [](const CardView& card, size_t i) { return card.motion.state().encoders[i].position; }},
    {"vel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const CardView& card, size_t i) { return card.motion.state().encoders[i].velocity; }},
};

constexpr MotionValue kPlantValues[] = {
    {"pos", NumberForm::kReal, Unit::kPulse,
     [](const CardView& card, size_t i) { return card.motion.state().plants[i].position; }},
    {"vel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const CardView& card, size_t i) { return card.motion.state().plants[i].velocity; }},
};

size_t CrdCount(const MotionCore& core) { return core.state().crds.size(); }

template <size_t kCoordinate>
double CrdPosition(const CardView& card, size_t index) {
  return card.motion.CrdPosition(index)[kCoordinate];
}

constexpr MotionValue kCrdValues[] = {
    {"x", NumberForm::kReal, Unit::kPulse, CrdPosition<0>},
    {"y", NumberForm::kReal, Unit::kPulse, CrdPosition<1>},
    {"z", NumberForm::kReal, Unit::kPulse, CrdPosition<2>},
    {"a", NumberForm::kReal, Unit::kPulse, CrdPosition<3>},
    {"vel", NumberForm::kReal, Unit::kPulsePerMs,
     [](const CardView& card, size_t i) { return card.motion.state().crds[i].run.velocity; }},
    Flag("run", [](const CardView& card,
                   size_t i) { return card.motion.state().crds[i].run.running ? 1.0 : 0.0; }),
    {"segment", NumberForm::kWhole, Unit::kNone,
     [](const CardView& card, size_t i) -> double {
       return card.motion.state().crds[i].active().done;
     }},
};

constexpr MotionValue kStepValues[] = {
    {"pos", NumberForm::kReal, Unit::kPulse,
     [](const CardView& card, size_t i) { return card.motion.state().steps[i].position; }},
};

constexpr MotionValue kDacValues[] = {
    {"", NumberForm::kWhole, Unit::kNone,
     [](const CardView& card, size_t i) -> double { return card.motion.state().dacs[i].Output(); }},
    {"volts", NumberForm::kReal, Unit::kVolt,
     [](const CardView& card, size_t i) { return card.motion.state().dacs[i].Volts(); }},
};

constexpr MotionValue kSpindleValues[] = {
    {"volts", NumberForm::kReal, Unit::kVolt,
     [](const CardView& card, size_t) {
       return card.motion.part<&motion::MotionState::spindle>()->Volts();
     }},
};

constexpr MotionValue kAdcValues[] = {
    {"", NumberForm::kWhole, Unit::kNone,
     [](const CardView& card, size_t i) -> double { return card.motion.state().adcs[i].Value(); }},
    {"volts", NumberForm::kReal, Unit::kVolt,
     [](const CardView& card, size_t i) { return card.motion.state().adcs[i].Volts(); }},
};

size_t EncoderCount(const MotionCore& core) {
  return core.has_auxiliary() ? motion::kAuxiliaryFirst + motion::kAuxiliaryCount
                              : core.axis_count();
}

constexpr MotionValue kHsioValues[] = {
    Flag("",
         [](const CardView& card, size_t i) {
           return card.motion.state().compare.output(i).Level(card.motion.now()) ? 1.0 : 0.0;
         }),
};

const motion::Laser& LaserAt(const CardView& card, size_t index) {
  return card.motion.state().lasers.channels[index];
}

double LaserPower(const CardView& card, size_t index) {
  return card.motion.readings().LaserPower(index);
}

constexpr MotionValue kLaserValues[] = {
    Flag("on", [](const CardView& card, size_t i) { return LaserAt(card, i).on ? 1.0 : 0.0; }),
    {"power", NumberForm::kReal, Unit::kNone, LaserPower},
    {"frequency", NumberForm::kReal, Unit::kKilohertz,
     [](const CardView& card, size_t i) {
       const motion::Laser& laser = LaserAt(card, i);
       return laser.mode == motion::LaserMode::kFrequency ? LaserPower(card, i)
                                                          : laser.pulse_frequency;
     }},
};

const motion::bus::BusDrive& DriveAt(const CardView& card, size_t axis) {
  const motion::BusPart& part = *card.motion.state().bus;
  return *part.line.slave(static_cast<size_t>(part.axes[axis].slave)).drive;
}

/// A drive that the card's axis has on the bus and that is connected.
bool HasDrive(const MotionCore& core, size_t axis) {
  if (!core.OnBus(axis)) return false;
  const motion::BusPart& part = *core.state().bus;
  const auto slave = static_cast<size_t>(part.axes[axis].slave);
  return slave < part.line.slave_count() && part.line.slave(slave).drive.has_value();
}

template <motion::bus::ObjectId kId>
double DriveObject(const CardView& card, size_t axis) {
  return static_cast<double>(DriveAt(card, axis).values()[kId]);
}

// As CiA 402 abbreviates them, with the gaps of its numbers.
constexpr std::string_view kDriveModes[] = {"none", "PP", "",    "PV",  "PT", "",
                                            "HM",   "",   "CSP", "CSV", "CST"};
constexpr std::string_view kDriveStates[] = {
    "not ready",         "switch-on disabled", "ready",          "switched on",
    "operation enabled", "quick stop",         "fault reaction", "fault"};
static_assert(std::size(kDriveStates) == motion::bus::kDriveStateCount);
constexpr std::string_view kDriveHoming[] = {"none",   "search", "leave", "index",
                                             "return", "done",   "failed"};

constexpr MotionValue kDriveValues[] = {
    {"state", NumberForm::kWhole, Unit::kNone,
     [](const CardView& card, size_t i) { return static_cast<double>(DriveAt(card, i).state()); },
     kDriveStates},
    {"mode", NumberForm::kWhole, Unit::kNone, DriveObject<motion::bus::ObjectId::kModeDisplay>,
     kDriveModes},
    {"control", NumberForm::kWhole, Unit::kNone, DriveObject<motion::bus::ObjectId::kControlWord>},
    {"status", NumberForm::kWhole, Unit::kNone, DriveObject<motion::bus::ObjectId::kStatusWord>},
    {"pos", NumberForm::kReal, Unit::kNone, DriveObject<motion::bus::ObjectId::kPositionActual>},
    {"homing", NumberForm::kWhole, Unit::kNone,
     [](const CardView& card, size_t i) {
       return static_cast<double>(DriveAt(card, i).homing().phase);
     },
     kDriveHoming},
};

constexpr std::array kParts = {
    MotionPart{"axis", AxisCount, kAxisValues, 1, nullptr, true},
    MotionPart{"profile", AxisCount, kProfileValues, 1, nullptr, true},
    MotionPart{"encoder", EncoderCount, kEncoderValues, 1,
               [](const MotionCore& core, size_t i) { return core.HasEncoder(i); }, true},
    MotionPart{"crd", CrdCount, kCrdValues},
    MotionPart{"plant", AxisCount, kPlantValues, 1, nullptr, true},
    MotionPart{"step", AxisCount, kStepValues, 1, nullptr, true},
    MotionPart{"dac", AxisCount, kDacValues},
    MotionPart{"spindle", [](const MotionCore&) -> size_t { return 1; }, kSpindleValues,
               kUnnumbered,
               [](const MotionCore& core, size_t) {
                 return static_cast<bool>(core.part<&motion::MotionState::spindle>());
               }},
    MotionPart{"adc", [](const MotionCore&) { return motion::kAdcCount; }, kAdcValues},
    MotionPart{kHsioPart, [](const MotionCore&) { return motion::kHsioCount; }, kHsioValues, 0},
    MotionPart{"laser", [](const MotionCore&) { return motion::kLaserCount; }, kLaserValues, 0},
    MotionPart{"drive", AxisCount, kDriveValues, 1, HasDrive},
};

}  // namespace

std::string_view UnitName(Unit unit, bool per_cycle) {
  switch (unit) {
    case Unit::kNone:
      break;
    case Unit::kPulse:
      return "pulse";
    case Unit::kPulsePerMs:
      return per_cycle ? "pulse/cycle" : "pulse/ms";
    case Unit::kPulsePerMs2:
      return per_cycle ? "pulse/cycle²" : "pulse/ms²";
    case Unit::kVolt:
      return "V";
    case Unit::kKilohertz:
      return "kHz";
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
  const std::string digits = part.first == kUnnumbered ? "" : std::to_string(number);
  return fmt::format("{}{}{}{}", part.name, digits, value.empty() ? "" : ".", value);
}

}  // namespace oncard::runtime
