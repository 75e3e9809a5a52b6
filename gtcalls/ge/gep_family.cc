#include "gtcalls/ge/gep_family.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "gtcalls/ge/command_register.h"
#include "gtcalls/ge/commands/commands.h"
#include "gtcalls/ge/ge_cards.h"
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

constexpr motion::CardDefaults kAnalogue = ge::kAnalogueDefaults;
constexpr motion::CardDefaults kPulses = ge::kPulseDefaults;

constexpr CardType kCardTypes[] = {
#define CARD_TYPE(name, axes, output) {name, axes, k##output},
#include "gtcalls/ge/gep_card_types.def"
};

/// All commands are supported.
constexpr bool IsUnsupported(std::string_view) { return false; }

#define FAMILY_COMMANDS "gtcalls/ge/gep_catalogue.def"
#include "gtcalls/rows/functions.inc"

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
      .not_open = ge::kNotOpen,
      .open_failed = ge::kNotOpen,
      .open_command = "GT_Open",
      .close_command = "GT_Close",
      .reset_commands = ge::kResetCommands,
      .advised = {.drive_on = "GT_AxisOn",
                  .velocity = "GT_SetVel",
                  .clear_status = "GT_ClrSts",
                  .following_error_limit = "GT_SetPosErr"},
      .finish =
          [](Call& call, int16_t code) {
            return ge::WriteCommandRegister(call, code,
                                            code == vm::kOk ? uint16_t{0} : ge::CauseOf(call));
          },
      .card_types = kCardTypes,
      .default_card = kCardTypes[0],
      .array_elements = ge::SamplesForHost,
      .status_word = gep::StatusWord,
      .mode_number = gep::ModeNumber,
      .new_state = [] { return FamilyState(GeState()); },
      .reset = [](FamilyState& state) { state = GeState(); },
      .after_tick = AfterTick,
      .cycles_before_act = CyclesBeforeAct,
  };
  return kFamily;
}

}  // namespace oncard::gtcalls
