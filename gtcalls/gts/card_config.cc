#include "gtcalls/gts/card_config.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

#include "base/number.h"
#include "base/trim.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::DiType;
using motion::DoType;
using motion::MotionCore;

// --- Sections and keys -------------------------------------------------------------------------

/// A key and the member that receives its value; nullptr: known, but without effect here.
template <typename Section>
struct Key {
  std::string_view name;
  double Section::*member = nullptr;
};

constexpr Key<CardConfig::Profile> kProfileKeys[] = {
    {"active", &CardConfig::Profile::active},
    {"decSmoothStop", &CardConfig::Profile::smooth_stop},
    {"decAbruptStop", &CardConfig::Profile::abrupt_stop},
};

constexpr Key<CardConfig::Axis> kAxisKeys[] = {
    {"active", &CardConfig::Axis::active},
    {"alarmType", &CardConfig::Axis::alarm_type},
    {"alarmIndex", &CardConfig::Axis::alarm_index},
    {"limitPositiveType", &CardConfig::Axis::positive_limit_type},
    {"limitPositiveIndex", &CardConfig::Axis::positive_limit_index},
    {"limitNegativeType", &CardConfig::Axis::negative_limit_type},
    {"limitNegativeIndex", &CardConfig::Axis::negative_limit_index},
    {"smoothStopType", &CardConfig::Axis::smooth_stop_type},
    {"smoothStopIndex", &CardConfig::Axis::smooth_stop_index},
    {"abruptStopType", &CardConfig::Axis::abrupt_stop_type},
    {"abruptStopIndex", &CardConfig::Axis::abrupt_stop_index},
    {"prfMap", &CardConfig::Axis::profile_map},
    {"encMap", &CardConfig::Axis::encoder_map},
    {"prfMapAlpha1", &CardConfig::Axis::profile_alpha},
    {"prfMapBeta1", &CardConfig::Axis::profile_beta},
    {"encMapAlpha1", &CardConfig::Axis::encoder_alpha},
    {"encMapBeta1", &CardConfig::Axis::encoder_beta},
    {"prfMapAlpha2"},
    {"prfMapBeta2"},
    {"encMapAlpha2"},
    {"encMapBeta2"},
};

constexpr Key<CardConfig::Control> kControlKeys[] = {
    {"active", &CardConfig::Control::active},
    {"axis", &CardConfig::Control::axis},
    {"encoder1", &CardConfig::Control::encoder},
    {"errorLimit", &CardConfig::Control::error_limit},
    {"encoder2"},
    {"filterType1"},
    {"filterType2"},
    {"filterType3"},
    {"filterType4"},
    {"encoderSmooth"},
    {"controlSmooth"},
};

constexpr Key<CardConfig::Dac> kDacKeys[] = {
    {"active", &CardConfig::Dac::active},   {"control", &CardConfig::Dac::control},
    {"reverse", &CardConfig::Dac::reverse}, {"bias", &CardConfig::Dac::bias},
    {"limit", &CardConfig::Dac::limit},
};

constexpr Key<CardConfig::Step> kStepKeys[] = {
    {"active", &CardConfig::Step::active},   {"axis", &CardConfig::Step::axis},
    {"mode", &CardConfig::Step::mode},       {"parameter", &CardConfig::Step::parameter},
    {"reverse", &CardConfig::Step::reverse},
};

/// According to the manual the capture keys have no effect.
constexpr Key<CardConfig::Encoder> kEncoderKeys[] = {
    {"active", &CardConfig::Encoder::active},
    {"reverse", &CardConfig::Encoder::reverse},
    {"filterType", &CardConfig::Encoder::filter_type},
    {"captureSource"},
    {"captureHomeSense"},
    {"captureIndexSense"},
};

constexpr Key<CardConfig::Output> kOutputKeys[] = {
    {"active", &CardConfig::Output::active},
    {"axis", &CardConfig::Output::axis},
    {"reverse", &CardConfig::Output::reverse},
    {"axisItem"},
};

constexpr Key<CardConfig::Input> kInputKeys[] = {
    {"active", &CardConfig::Input::active},
    {"reverse", &CardConfig::Input::reverse},
    {"filterTime", &CardConfig::Input::filter_ticks},
};

/// In the order of DoType and DiType.
constexpr std::string_view kOutputSections[] = {"enable", "clear", "gpo"};
constexpr std::string_view kInputSections[] = {"limitPositive", "limitNegative", "alarm", "home",
                                               "gpi",           "arrive",        "mpg"};

// --- Reading -----------------------------------------------------------------------------------

class ConfigReader {
 public:
  CardConfig Read(std::string_view text) {
    for (size_t begin = 0; begin < text.size();) {
      const size_t end = std::min(text.find('\n', begin), text.size());
      ReadLine(Trim(text.substr(begin, end - begin)));
      begin = end + 1;
    }
    return std::move(config_);
  }

 private:
  void ReadLine(std::string_view line) {
    if (line.empty() || line.front() == ';' || line.front() == '#') return;
    if (line.front() == '[') {
      OpenSection(line);
      return;
    }
    const size_t equals = line.find('=');
    if (section_.empty() || equals == std::string_view::npos) return;
    ReadKey(Trim(line.substr(0, equals)), Trim(line.substr(equals + 1)));
  }

  /// `[name12]`. Lines after an unknown section are skipped.
  void OpenSection(std::string_view line) {
    const std::string_view inside = line.substr(1, line.find(']') - 1);
    const size_t digits = std::min(inside.find_first_of("0123456789"), inside.size());
    section_ = inside.substr(0, digits);
    const auto number = ReadNumber(inside.substr(digits));
    number_ = number && *number >= 1 && *number <= motion::kIoWidthMax ? size_t(*number) : 0;
    if (Count(section_) >= number_ && number_ > 0 && line.back() == ']') return;
    Remark(MakeMessage("section '{0}' is unknown and has no effect", "未知的节“{0}”，不起作用",
                       inside));
    section_ = {};
  }

  /// The maximum number of sections with this name.
  static size_t Count(std::string_view name) {
    if (std::ranges::count(kOutputSections, name) + std::ranges::count(kInputSections, name) > 0) {
      return motion::kIoWidthMax;
    }
    constexpr std::string_view kAxisSections[] = {"profile", "axis", "control",
                                                  "dac",     "step", "encoder"};
    return std::ranges::count(kAxisSections, name) > 0 ? kAxisMax : 0;
  }

  void ReadKey(std::string_view name, std::string_view text) {
    const size_t i = number_ - 1;
    if (section_ == "profile") return Assign(kProfileKeys, config_.profiles[i], name, text);
    if (section_ == "axis") return Assign(kAxisKeys, config_.axes[i], name, text);
    if (section_ == "control") return Assign(kControlKeys, config_.controls[i], name, text);
    if (section_ == "dac") return Assign(kDacKeys, config_.dacs[i], name, text);
    if (section_ == "step") return Assign(kStepKeys, config_.steps[i], name, text);
    if (section_ == "encoder") return Assign(kEncoderKeys, config_.encoders[i], name, text);
    const auto* output = std::ranges::find(kOutputSections, section_);
    if (output != std::end(kOutputSections)) {
      const auto word = static_cast<size_t>(output - kOutputSections);
      return Assign(kOutputKeys, config_.outputs[word][i], name, text);
    }
    const auto word =
        static_cast<size_t>(std::ranges::find(kInputSections, section_) - kInputSections);
    Assign(kInputKeys, config_.inputs[word][i], name, text);
  }

  template <typename Section, size_t size>
  void Assign(const Key<Section> (&keys)[size], Section& section, std::string_view name,
              std::string_view text) {
    for (const Key<Section>& key : keys) {
      if (key.name != name) continue;
      if (key.member == nullptr) return;
      if (const auto value = ReadNumber(text)) {
        section.*key.member = *value;
      } else {
        Remark(MakeMessage("key '{0}' of sections '{1}' is '{2}', which is not a number",
                           "节“{1}”的键“{0}”为“{2}”，不是数字", name, section_, text));
      }
      return;
    }
    Remark(MakeMessage("key '{0}' of sections '{1}' is unknown and has no effect",
                       "节“{1}”的键“{0}”未知，不起作用", name, section_));
  }

  void Remark(Message message) {
    const bool known = std::ranges::any_of(
        config_.remarks, [&](const Message& other) { return other.en == message.en; });
    if (!known) config_.remarks.push_back(std::move(message));
  }

  CardConfig config_;
  std::string_view section_;  ///< empty: skip what follows
  size_t number_ = 0;         ///< of the section, from 1
};

// --- Applying ----------------------------------------------------------------------------------

/// The number of an axis, controller or encoder, counted from 0; empty for "none" and for invalid
/// numbers.
std::optional<size_t> IndexFrom(double number) {
  if (!(number >= 1 && number <= kAxisMax)) return std::nullopt;
  return static_cast<size_t>(number - 1);
}

/// The same as a register value: -1 for "none".
int8_t NumberFrom(double number) {
  const auto index = IndexFrom(number);
  return index ? static_cast<int8_t>(*index) : int8_t{-1};
}

int16_t ShortFrom(double value, double smallest, double largest) {
  return static_cast<int16_t>(std::clamp(value, smallest, largest));
}

/// Profiles or encoders of the largest GTS card; further bits are ignored.
uint32_t MapFrom(double value) {
  constexpr uint32_t kAll = (uint32_t{1} << kAxisMax) - 1;
  return value >= 0 && value <= 4294967295.0 ? static_cast<uint32_t>(value) & kAll : 0;
}

/// A deceleration that GT_SetStopDec would accept; for any other value the old one is kept.
double DecelerationFrom(double value, double old) {
  return value >= kAboveZero && value <= 32767 ? value : old;
}

/// An input beyond the end of its word never triggers.
motion::InputChoice ChoiceFrom(double type, double index) {
  const auto word = DiTypeOf(static_cast<int>(std::clamp(type, -1.0, 99.0)));
  if (!word || !(index >= 1 && index <= motion::kIoWidthMax)) return {};
  return {*word, static_cast<int16_t>(index - 1)};
}

/// For an invalid ratio the old one is kept.
motion::Scale ScaleFrom(double alpha, double beta, const motion::Scale& old) {
  alpha = std::trunc(alpha);
  beta = std::trunc(beta);
  const double magnitude = std::fabs(alpha);
  if (!(beta != 0 && magnitude >= std::fabs(beta) && magnitude < 32767)) return old;
  return {static_cast<int16_t>(alpha), static_cast<int16_t>(beta)};
}

void ApplyAxis(const CardConfig::Axis& config, size_t index, MotionCore& core) {
  const motion::AxisHandle axis = core.AxisAt(index);
  axis.SetActive(config.active != 0);
  axis.SetInputs(
      {.alarm = ChoiceFrom(config.alarm_type, config.alarm_index),
       .positive_limit = ChoiceFrom(config.positive_limit_type, config.positive_limit_index),
       .negative_limit = ChoiceFrom(config.negative_limit_type, config.negative_limit_index),
       .smooth_stop = ChoiceFrom(config.smooth_stop_type, config.smooth_stop_index),
       .abrupt_stop = ChoiceFrom(config.abrupt_stop_type, config.abrupt_stop_index)});
  axis.SwitchAlarm(true);
  axis.SwitchPositiveLimit(true);
  axis.SwitchNegativeLimit(true);
  const motion::Axis& old = core.axis(index);
  axis.SetMaps(
      {.profiles = MapFrom(config.profile_map),
       .encoders = MapFrom(config.encoder_map),
       .profile_scale = ScaleFrom(config.profile_alpha, config.profile_beta, old.profile_scale),
       .encoder_scale = ScaleFrom(config.encoder_alpha, config.encoder_beta, old.encoder_scale)});
}

void ApplyEncoder(const CardConfig::Encoder& config, size_t index, MotionCore& core) {
  core.EncoderAt(index).Configure(config.active != 0, config.reverse != 0, config.filter_type == 0);
}

/// The controller that an analogue output gets: an active one that has an axis and an external
/// encoder. Empty: none.
std::optional<size_t> OwnerOf(const CardConfig& config, size_t dac, const MotionCore& core) {
  const auto owner = IndexFrom(config.dacs[dac].control);
  if (config.dacs[dac].active == 0 || !owner) return std::nullopt;
  const CardConfig::Control& control = config.controls[*owner];
  const auto encoder = IndexFrom(control.encoder);
  const bool usable =
      control.active != 0 && IndexFrom(control.axis) && encoder && core.encoder(*encoder).external;
  return usable ? owner : std::nullopt;
}

/// Closes the loop of each controller that has an output.
void ApplyControls(const CardConfig& config, MotionCore& core) {
  for (size_t i = 0; i < kAxisMax; ++i) {
    const CardConfig::Control& from = config.controls[i];
    const motion::ControlHandle control = core.ControlAt(i);
    control.Configure(from.active != 0, NumberFrom(from.axis), NumberFrom(from.encoder));
    control.SetErrorLimit(static_cast<int64_t>(std::clamp(from.error_limit, 1.0, 2147483648.0)));
  }
  for (size_t i = 0; i < kAxisMax; ++i) {
    const CardConfig::Dac& from = config.dacs[i];
    const motion::DacHandle dac = core.DacAt(i);
    dac.Configure(from.active != 0, from.reverse != 0,
                  ShortFrom(from.bias, -motion::kDacFull, motion::kDacFull),
                  ShortFrom(from.limit, 0, motion::kDacFull));
    if (const auto owner = OwnerOf(config, i, core)) dac.GiveTo(*owner);
  }
}

void ApplySteps(const CardConfig& config, MotionCore& core) {
  for (size_t i = 0; i < kAxisMax; ++i) {
    const CardConfig::Step& from = config.steps[i];
    const motion::StepHandle step = core.StepAt(i);
    step.Configure(from.active != 0, NumberFrom(from.axis), from.reverse != 0);
    step.SetMode(ShortFrom(from.mode, -32768, 32767));
    step.SetParameter(ShortFrom(from.parameter, -32768, 32767));
  }
}

void ApplyDigital(const CardConfig& config, MotionCore& core) {
  motion::DigitalIo& io = core.digital_io();
  for (size_t word = 0; word < config.inputs.size(); ++word) {
    const auto type = static_cast<DiType>(word);
    uint32_t inverted = 0;
    uint32_t active = ~uint32_t{0};
    for (size_t bit = 0; bit < motion::kIoWidthMax; ++bit) {
      const CardConfig::Input& input = config.inputs[word][bit];
      inverted |= uint32_t{input.reverse != 0} << bit;
      active ^= uint32_t{input.active == 0} << bit;
      io.SetFilterTicks(type, static_cast<int>(bit),
                        static_cast<uint16_t>(std::clamp(input.filter_ticks, 0.0, 65535.0)));
    }
    io.SetInverted(type, inverted);
    io.SetInputsActive(type, active);
  }
  for (size_t word = 0; word < config.outputs.size(); ++word) {
    const auto type = static_cast<DoType>(word);
    uint32_t inverted = 0;
    uint32_t active = ~uint32_t{0};
    for (size_t bit = 0; bit < motion::kIoWidthMax; ++bit) {
      inverted |= uint32_t{config.outputs[word][bit].reverse != 0} << bit;
      active ^= uint32_t{config.outputs[word][bit].active == 0} << bit;
    }
    io.SetOutputInverted(type, inverted);
    io.SetOutputsActive(type, active);
  }
  for (size_t i = 0; i < motion::kAxisIoWidth; ++i) {
    core.SetEnableAxis(i, NumberFrom(config.outputs[0][i].axis));
  }
}

void ApplyProfile(const CardConfig::Profile& config, size_t index, MotionCore& core) {
  const motion::Profile& old = core.profile(index);
  const motion::ProfileHandle profile = core.ProfileAt(index);
  profile.SetStopDecelerations(DecelerationFrom(config.smooth_stop, old.smooth_stop),
                               DecelerationFrom(config.abrupt_stop, old.abrupt_stop));
  profile.SetActive(config.active != 0);
}

}  // namespace

CardConfig::CardConfig() {
  for (size_t i = 0; i < kAxisMax; ++i) {
    const auto number = static_cast<double>(i + 1);
    const double bit = static_cast<double>(uint32_t{1} << i);
    axes[i].alarm_index = number;
    axes[i].positive_limit_index = number;
    axes[i].negative_limit_index = number;
    axes[i].profile_map = bit;
    axes[i].encoder_map = bit;
    controls[i].axis = number;
    controls[i].encoder = number;
    steps[i].axis = number;
    outputs[0][i].axis = number;
  }
}

CardConfig ParseCardConfig(std::string_view text) { return ConfigReader().Read(text); }

void ApplyCardConfig(const CardConfig& config, MotionCore* core) {
  ApplyDigital(config, *core);
  for (size_t i = 0; i < kAxisMax; ++i) {
    ApplyProfile(config.profiles[i], i, *core);
    ApplyAxis(config.axes[i], i, *core);
  }
  ApplySteps(config, *core);
  for (size_t i = 0; i < kAxisMax; ++i) ApplyEncoder(config.encoders[i], i, *core);
  ApplyControls(config, *core);
  core->RestartDrives();
}

}  // namespace oncard::gtcalls::gts
