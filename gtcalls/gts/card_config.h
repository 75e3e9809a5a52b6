// The vendor's configuration files (*.cfg): ini sections [profile1] ... [mpg7] that say how the
// card's parts are connected. The reader is tolerant, as real files require: unknown entries become
// remarks and are otherwise ignored. Source: GTS manual 4.3 and files of the vendor's tool. Tested
// by tests/gtcalls/card_config_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "gtcalls/gts/defaults.h"
#include "gtcalls/gts/limits.h"
#include "motion/motion_core.h"

namespace oncard::gtcalls::gts {

/// GT_LoadConfig: longest file name.
inline constexpr size_t kConfigPathMax = 125;

/// A complete configuration with the numbers in the file: all count from 1, -1 means none. Values
/// that a file does not set are those after GT_Reset.
struct CardConfig {
  struct Profile {
    double active = 1;
    double smooth_stop = kDefaults.smooth_stop;
    double abrupt_stop = kDefaults.abrupt_stop;
  };
  struct Axis {
    double active = 1;
    double alarm_type = 2, alarm_index = -1;
    double positive_limit_type = 0, positive_limit_index = -1;
    double negative_limit_type = 1, negative_limit_index = -1;
    double smooth_stop_type = 4, smooth_stop_index = -1;
    double abrupt_stop_type = 4, abrupt_stop_index = -1;
    double profile_map = 0, encoder_map = 0;
    double profile_alpha = 1, profile_beta = 1;
    double encoder_alpha = 1, encoder_beta = 1;
  };
  struct Control {
    double active = 1;
    double axis = -1;
    double encoder = -1;
    double error_limit = 32767;
  };
  struct Dac {
    double active = 1;
    double control = -1;
    double reverse = 0;
    double bias = 0;
    double limit = 32767;
  };
  struct Step {
    double active = 1;
    double axis = -1;
    double mode = 0;
    double parameter = 0;
    double reverse = 0;
  };
  struct Encoder {
    double active = 1;
    double reverse = 1;
    double filter_type = 0;  ///< 0: the external encoder, others: the pulse counter
  };
  struct Output {
    double active = 1;
    double axis = -1;
    double reverse = 0;
  };
  struct Input {
    double active = 1;
    double reverse = 0;
    double filter_ticks = kDefaults.filter_ticks;
  };

  std::array<Profile, kAxisMax> profiles;
  std::array<Axis, kAxisMax> axes;
  std::array<Control, kAxisMax> controls;
  std::array<Dac, kAxisMax> dacs;
  std::array<Step, kAxisMax> steps;
  std::array<Encoder, kAxisMax> encoders;
  std::array<std::array<Output, motion::kIoWidthMax>, motion::kDoTypeCount> outputs;
  std::array<std::array<Input, motion::kIoWidthMax>, motion::kDiTypeCount> inputs;

  /// Remarks on entries that were not understood, each kind once.
  std::vector<Message> remarks;

  CardConfig();
};

/// Reads the text of a file; never fails.
CardConfig ParseCardConfig(std::string_view text);

/// Configures a card at rest. Latched status bits stay until GT_ClrSts; nothing moves, and encoders
/// keep their positions.
void ApplyCardConfig(const CardConfig& config, motion::MotionCore* core);

}  // namespace oncard::gtcalls::gts
