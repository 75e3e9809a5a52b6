#include "gtcalls/gt400/family.h"

#include <array>
#include <limits>
#include <string_view>

#include "gtcalls/gt400/catalogue.h"
#include "gtcalls/gt400/command_register.h"
#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/gt400/cycle.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/gt400/interrupts.h"
#include "gtcalls/gt400/limits.h"
#include "gtcalls/gt400/paths.h"
#include "gtcalls/gt400/rows.h"
#include "gtcalls/gt400/status_word.h"
#include "gtcalls/gt400/unsupported.h"

namespace oncard::gtcalls {
namespace gt400 {
namespace {

// What GT400 commands accept fits into the core. The distance between two positions fits an
// int32_t.
static_assert(kAxisMax <= motion::kAxisMax && kAxisMax == motion::kMappedAxisMax);
static_assert(kCoordinateMax == motion::kCrdDimensionMax);
static_assert(int64_t{kPositionMax} - kPositionMin <= std::numeric_limits<int32_t>::max());

/// Table 2-1 of the GT manual: "communication error".
constexpr int16_t kNotOpen = -1;
/// What the environment says cannot be used.
constexpr int16_t kOpenFailed = -6;

constexpr std::string_view kResetCommands[] = {"GT_Reset", "GT_HardRst"};

/// An axis that stops at once rests where it is.
constexpr double kAtOnce = std::numeric_limits<double>::infinity();
/// Assumption: inputs have no filter.
constexpr uint16_t kFilterTicks = 1;

constexpr motion::CardDefaults kAnalogue = {.smooth_stop = 1,
                                            .abrupt_stop = kAtOnce,
                                            .filter_ticks = kFilterTicks,
                                            .alarm_on = true,
                                            .limits_on = true,
                                            .encoders_external = true,
                                            .encoders_reversed = false,
                                            .closed_loop = true,
                                            .following_error_limit = kServoMax,
                                            .following_error_stops = false,
                                            .enabling_aligns = false,
                                            .slaves_last = true};
/// With pulses only: no motor is in closed loop, whose position error counts.
constexpr motion::CardDefaults kPulses = [] {
  motion::CardDefaults defaults = kAnalogue;
  defaults.closed_loop = false;
  defaults.following_error_limit = std::numeric_limits<int64_t>::max();
  return defaults;
}();

constexpr motion::CardDefaults kPulsesAlone = [] {
  motion::CardDefaults defaults = kPulses;
  defaults.auxiliary_encoders = false;
  return defaults;
}();

constexpr CardType kCardTypes[] = {
#define CARD_TYPE(name, axes, output) {name, axes, k##output},
#include "gtcalls/gt400/card_types.def"
};

#define FAMILY_COMMANDS "gtcalls/gt400/catalogue.def"
#include "gtcalls/rows/functions.inc"

}  // namespace
}  // namespace gt400

const Family& Gt400Family() {
  using namespace gt400;  // whose names other families have, too
  static const Family kFamily = {
      .name = "gt400",
      .catalogue = Gt400Catalogue(),
      .functions = kFunctions,
      .not_supported = kNotSimulated,
      .not_open = kNotOpen,
      .open_failed = kOpenFailed,
      .open_command = "GT_Open",
      .close_command = "GT_Close",
      .reset_commands = gt400::kResetCommands,
      .why_unsupported = gt400::WhyUnsupported,
      .advised = {.drive_on = "GT_AxisOn",
                  .velocity = "GT_SetVel",
                  .clear_status = "GT_ClrSts",
                  .following_error_limit = "GT_SetPosErr",
                  .append_segment = "GT_LnXY",
                  .start_path = "GT_StrtMtn"},
      .finish =
          [](Call& call, int16_t code) {
            NoticePathStop(call.card);
            NoticeCommand(call.card);
            return WriteCommandRegister(call, code);
          },
      .card_types = gt400::kCardTypes,
      .default_card = gt400::kCardTypes[0],
      .cycle_ns = static_cast<int64_t>(kSampleTime * kNsPerUs),
      .status_word = gt400::StatusWord,
      .mode_number = gt400::ModeNumber,
      .new_state = [] { return FamilyState(Gt400State()); },
      .reset = [](FamilyState& state) { std::get_if<Gt400State>(&state)->Reset(); },
      .after_tick = gt400::AfterTick,
      .cycles_before_act = gt400::CyclesBeforeAct,
      .cycles_before_interrupt = gt400::CyclesBeforeInterrupt,
  };
  return kFamily;
}

}  // namespace oncard::gtcalls
