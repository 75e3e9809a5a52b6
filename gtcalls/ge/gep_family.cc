#include "gtcalls/ge/gep_family.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "gtcalls/ge/command_register.h"
#include "gtcalls/ge/commands/commands.h"
#include "gtcalls/ge/gep_catalogue.h"
#include "gtcalls/ge/gep_rows.h"
#include "gtcalls/ge/limits.h"
#include "gtcalls/ge/status_words.h"

namespace oncard::gtcalls {
namespace gep {
namespace {

// What GE commands accept fits into the core. The distance between two positions fits an int32_t.
static_assert(ge::kAxisMax <= motion::kAxisMax && ge::kAdcMax <= motion::kAdcCount);
static_assert(ge::kPositionMax - ge::kPositionMin <= std::numeric_limits<int32_t>::max());

/// GE manual table 2-1: "communication failed". The manual has no other code for GT_Open.
constexpr int16_t kNotOpen = -1;

constexpr std::string_view kResetCommands[] = {"GT_Reset", "GT_HardRst"};

/// The cycle in which a motion has ended is the last one: the axis rests where it is.
constexpr double kAtOnce = std::numeric_limits<double>::infinity();

/// After a reset: GE manual 3.2.2, 6.7.2.1 and chapter 12. A card with pulses only has no motors in
/// closed loop, whose following error counts.
constexpr motion::CardDefaults kAnalogue = {.smooth_stop = 1,
                                            .abrupt_stop = kAtOnce,
                                            .filter_ticks = 3,
                                            .alarm_on = true,
                                            .limits_on = true,
                                            .encoders_external = true,
                                            .encoders_reversed = false,
                                            .closed_loop = true,
                                            .following_error_limit = ge::kServoLimitMax,
                                            .following_error_stops = false};
constexpr motion::CardDefaults kPulses = {
    .smooth_stop = 1,
    .abrupt_stop = kAtOnce,
    .filter_ticks = 3,
    .alarm_on = false,
    .limits_on = true,
    .encoders_external = false,
    .encoders_reversed = false,
    .closed_loop = false,
    .following_error_limit = std::numeric_limits<int64_t>::max(),
    .following_error_stops = false};

constexpr CardType kCardTypes[] = {
#define CARD_TYPE(name, axes, output) {name, axes, k##output},
#include "gtcalls/ge/gep_card_types.def"
};

/// Assumption: the manual names no time. A call of GTS takes as long.
constexpr int64_t kHostCallUs = 50;

constexpr size_t kCommandCount = 0
#define COMMAND(...) +1
#include "gtcalls/ge/gep_catalogue.def"
    ;

/// The functions of the commands; the index is the command's number - 1.
constexpr auto kFunctions = [] {
  using words::Callers;
  std::array<CommandFunction, kCommandCount> functions{};
#define COMMAND(number, name, tier, callers, ...) \
  if constexpr (Callers::callers != Callers::kLibrary) functions[number - 1u] = gep::name;
#include "gtcalls/ge/gep_catalogue.def"
  return functions;
}();

/// The command register after a command: the causes of the last one only.
int16_t WriteCommandRegister(Call& call, int16_t code) {
  uint16_t& command_register = call.card.state<GeState>().command_register;
  if (code != vm::kOk) {
    command_register = ge::CauseOf(call);
  } else if (call.command.name != "GT_GetCmdSts") {
    command_register = 0;
  }
  return code;
}

/// Assumption: an automatic stop leaves the drive enabled.
void StopBeyondErrorLimit(const Card& card) {
  const GeState& state = card.state<GeState>();
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
    if (!state.axes[axis].auto_stop || !card.motion.axis(axis).servo_on) continue;
    if (card.motion.FollowingErrorExceeded(axis)) card.motion.ProfileAt(axis).Stop(true);
  }
}

void AfterTick(Card& card) {
  StopBeyondErrorLimit(card);
  card.state<GeState>().watch.Advance(card.view());
}

int64_t CyclesBeforeAct(const CardView& card) {
  const GeState& state = card.state<GeState>();
  const bool acts =
      state.watch.batches.running() || std::ranges::any_of(state.axes, &GeAxis::auto_stop);
  return acts ? 0 : kNeverActs;
}

}  // namespace
}  // namespace gep

const Family& GepFamily() {
  using namespace gep;  // whose names other families have, too
  static const Family kFamily = {
      .name = "gep",
      .catalogue = GepCatalogue(),
      .functions = kFunctions,
      .not_supported = vm::kRefused,
      .not_open = kNotOpen,
      .open_failed = kNotOpen,
      .open_command = "GT_Open",
      .close_command = "GT_Close",
      .reset_commands = kResetCommands,
      .why_unsupported = [](const Command&) -> const Message* { return nullptr; },
      .motion_role = [](const Command&) { return MotionRole::kNone; },
      .advised = {.drive_on = "GT_AxisOn",
                  .velocity = "GT_SetVel",
                  .clear_status = "GT_ClrSts",
                  .following_error_limit = "GT_SetPosErr"},
      .finish = WriteCommandRegister,
      .card_types = kCardTypes,
      .default_card = kCardTypes[0],
      .cost_us = [](const Command& command) -> int64_t {
        return command.cost == Cost::kNone ? 0 : kHostCallUs;
      },
      .status_word = gep::StatusWord,
      .mode_number = gep::ModeNumber,
      .new_state = [] { return FamilyState(GeState()); },
      .reset = [](FamilyState& state) { state = GeState(); },
      .forget_program = [](FamilyState&) {},
      .after_tick = AfterTick,
      .before_threads = [](Card&) {},
      .cycles_before_act = CyclesBeforeAct,
      .writes_variables = [](const CardView&) { return false; },
      .memory_text = [](const FamilyState&) { return std::string(); },
      .restore_memory = [](std::string_view, std::string_view,
                           FamilyState&) { return Result<void>(); },
  };
  return kFamily;
}

}  // namespace oncard::gtcalls
