#include "gtcalls/ge/ges_family.h"

#include <array>

#include "gtcalls/ge/command_register.h"
#include "gtcalls/ge/commands/path_support.h"
#include "gtcalls/ge/ge_cards.h"
#include "gtcalls/ge/ges_catalogue.h"
#include "gtcalls/ge/ges_rows.h"
#include "gtcalls/ge/ges_unsupported.h"
#include "gtcalls/ge/status_words.h"

namespace oncard::gtcalls {
namespace ges {
namespace {

/// The decelerations of a path are set when it begins.
constexpr motion::CardDefaults WithSpindle(motion::CardDefaults defaults) {
  defaults.spindle = true;
  return defaults;
}

constexpr motion::CardDefaults kAnalogue = WithSpindle(ge::kAnalogueDefaults);
constexpr motion::CardDefaults kPulses = WithSpindle(ge::kPulseDefaults);

constexpr CardType kCardTypes[] = {
#define CARD_TYPE(name, axes, output) {name, axes, k##output},
#include "gtcalls/ge/ges_card_types.def"
};

#define FAMILY_COMMANDS "gtcalls/ge/ges_catalogue.def"
#include "gtcalls/rows/functions.inc"

/// Why a command was refused: what it has said itself; codes of geometry and feeds are figures that
/// are not correct; and a command that the card does not have has no function.
uint16_t CauseOf(const Call& call, int16_t code) {
  if (call.cause != 0) return call.cause;
  if (code == vm::kBadParameter) return ge::kIllegal;
  return call.card.family.Executes(call.command) ? 0 : ge::kNotOnCard;
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
      .not_open = ge::kNotOpen,
      .open_failed = ge::kNotOpen,
      .open_command = "GT_Open",
      .close_command = "GT_Close",
      .reset_commands = ge::kResetCommands,
      .why_unsupported = WhyUnsupported,
      .advised = {.drive_on = "GT_AxisOn",
                  .velocity = "GT_SetSynVel",
                  .clear_status = "GT_ClrSts",
                  .following_error_limit = "GT_SetPosErr",
                  .append_segment = "GT_LnXY",
                  .start_path = "GT_StrtMtn",
                  .look_ahead = "GT_InitLookAheadEx"},
      .finish =
          [](Call& call, int16_t code) {
            return ge::WriteCommandRegister(call, code,
                                            code == vm::kOk ? uint16_t{0} : CauseOf(call, code));
          },
      .card_types = kCardTypes,
      .default_card = kCardTypes[0],
      .array_elements = ge::SamplesForHost,
      .status_word = ges::StatusWord,
      .mode_number = [](motion::ProfileMode) { return 0; },
      .new_state = [] { return FamilyState(NewState()); },
      .reset = [](FamilyState& state) { state = NewState(); },
      .after_tick = AfterTick,
      .cycles_before_act = CyclesBeforeAct,
  };
  return kFamily;
}

}  // namespace oncard::gtcalls
