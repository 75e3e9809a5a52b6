#include "gtcalls/ge/ges_family.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "gtcalls/ge/command_register.h"
#include "gtcalls/ge/commands/path_support.h"
#include "gtcalls/ge/ges_catalogue.h"
#include "gtcalls/ge/ges_rows.h"
#include "gtcalls/ge/ges_unsupported.h"
#include "gtcalls/ge/status_words.h"

namespace oncard::gtcalls {
namespace ges {
namespace {

/// GE manual table 2-1: "communication failed". The manual has no other code for GT_Open.
constexpr int16_t kNotOpen = -1;

constexpr std::string_view kResetCommands[] = {"GT_Reset", "GT_HardRst"};

/// After a reset: GE manual 3.2.2, 6.7.2.1 and chapter 12. The decelerations of a path are set when
/// it begins; an axis stops at once.
constexpr double kAtOnce = std::numeric_limits<double>::infinity();
constexpr motion::CardDefaults kAnalogue = {.smooth_stop = 1,
                                            .abrupt_stop = kAtOnce,
                                            .filter_ticks = 3,
                                            .alarm_on = true,
                                            .limits_on = true,
                                            .encoders_external = true,
                                            .encoders_reversed = false,
                                            .closed_loop = true,
                                            .following_error_limit = ge::kServoLimitMax,
                                            .following_error_stops = false,
                                            .spindle = true};
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
    .following_error_stops = false,
    .spindle = true};

constexpr CardType kCardTypes[] = {
#define CARD_TYPE(name, axes, output) {name, axes, k##output},
#include "gtcalls/ge/ges_card_types.def"
};

/// Assumption: the manual names no time. A call of GTS takes as long.
constexpr int64_t kHostCallUs = 50;

constexpr size_t kCommandCount = 0
#define COMMAND(...) +1
#include "gtcalls/ge/ges_catalogue.def"
    ;

/// The functions of the commands; the index is the command's number - 1.
constexpr auto kFunctions = [] {
  using words::Callers;
  std::array<CommandFunction, kCommandCount> functions{};
#define COMMAND(number, name, tier, callers, ...)                                 \
  if constexpr (Callers::callers != Callers::kLibrary && !IsUnsupported(#name)) { \
    functions[number - 1u] = ges::name;                                           \
  }
#include "gtcalls/ge/ges_catalogue.def"
  return functions;
}();

/// Why a command was refused: what it has said itself; codes of geometry and feeds are figures that
/// are not correct; and a command that the card does not have has no function.
uint16_t CauseOf(const Call& call, int16_t code) {
  if (call.cause != 0) return call.cause;
  if (code == vm::kBadParameter) return ge::kIllegal;
  return call.card.family.Executes(call.command) ? 0 : ge::kNotOnCard;
}

/// The command register after a command: the causes of the last one only.
int16_t WriteCommandRegister(Call& call, int16_t code) {
  uint16_t& command_register = call.card.state<GeState>().command_register;
  if (code != vm::kOk) {
    command_register = CauseOf(call, code);
  } else if (call.command.name != "GT_GetCmdSts") {
    command_register = 0;
  }
  return code;
}

/// A following error stops the whole path; the drive stays enabled (assumption).
void StopBeyondErrorLimit(Card& card) {
  const motion::MotionCore& core = card.motion;
  for (size_t axis = 0; PathRuns(card) && axis < core.axis_count(); ++axis) {
    if (core.axis(axis).servo_on && core.FollowingErrorExceeded(axis))
      card.motion.CrdAt(0).Stop(true);
  }
}

void AfterTick(Card& card) {
  StopBeyondErrorLimit(card);
  NoticePath(card);
  NoticeWheel(card);
  card.state<GeState>().watch.Advance(card.view());
}

int64_t CyclesBeforeAct(const CardView& card) {
  const GeState& state = card.state<GeState>();
  const bool acts =
      state.watch.batches.running() || state.path->runs || state.path->wheel.axis != 0;
  return acts ? 0 : kNeverActs;
}

GeState NewState() {
  GeState state;
  state.path.Emplace();
  return state;
}

}  // namespace
}  // namespace ges

const Family& GesFamily() {
  using namespace ges;  // whose names other families have, too
  static const Family kFamily = {
      .name = "ges",
      .catalogue = GesCatalogue(),
      .functions = kFunctions,
      .not_supported = vm::kRefused,
      .not_open = kNotOpen,
      .open_failed = kNotOpen,
      .open_command = "GT_Open",
      .close_command = "GT_Close",
      .reset_commands = kResetCommands,
      .why_unsupported = WhyUnsupported,
      .motion_role = [](const Command&) { return MotionRole::kNone; },
      .advised = {.drive_on = "GT_AxisOn",
                  .velocity = "GT_SetSynVel",
                  .clear_status = "GT_ClrSts",
                  .following_error_limit = "GT_SetPosErr",
                  .append_segment = "GT_LnXY",
                  .start_path = "GT_StrtMtn",
                  .look_ahead = "GT_InitLookAheadEx"},
      .finish = WriteCommandRegister,
      .card_types = kCardTypes,
      .default_card = kCardTypes[0],
      .cost_us = [](const Command& command) -> int64_t {
        return command.cost == Cost::kNone ? 0 : kHostCallUs;
      },
      .status_word = ges::StatusWord,
      .mode_number = [](motion::ProfileMode) { return 0; },
      .new_state = [] { return FamilyState(NewState()); },
      .reset = [](FamilyState& state) { state = NewState(); },
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
