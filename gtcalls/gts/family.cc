#include "gtcalls/gts/family.h"

#include <array>
#include <string_view>
#include <utility>

#include "gtcalls/gts/buffered_values.h"
#include "gtcalls/gts/catalogue.h"
#include "gtcalls/gts/commands/commands.h"
#include "gtcalls/gts/commands/crd_support.h"
#include "gtcalls/gts/defaults.h"
#include "gtcalls/gts/limits.h"
#include "gtcalls/gts/motion_roles.h"
#include "gtcalls/gts/mram_text.h"
#include "gtcalls/gts/numbers.h"
#include "gtcalls/gts/profile_modes.h"
#include "gtcalls/gts/status_word.h"
#include "gtcalls/gts/unsupported.h"
#include "gtcalls/gts/words.h"

namespace oncard::gtcalls {
namespace gts {
namespace {

#define FAMILY_COMMANDS "gtcalls/gts/catalogue.def"
#include "gtcalls/rows/functions.inc"

}  // namespace
}  // namespace gts

namespace {

// What GTS commands accept fits into the cores.
static_assert(gts::kAxisMax <= motion::kAxisMax && gts::kCrdMax <= motion::kCrdCount &&
              gts::kPvtTableMax <= motion::kPvtTableCount && gts::kAdcMax <= motion::kAdcCount &&
              gts::kModuleLast < motion::kModuleCount &&
              gts::kModuleChannelLast < motion::kModuleChannels);
static_assert(gts::words::kEnableWord == gts::kOutputWordFirst);
static_assert(gts::kPositionMax <= motion::kPositionMax && gts::kAboveZero >= motion::kRateMin);
static_assert(gts::kShaperCyclesMax <= motion::kShaperCyclesMax);
static_assert(gts::kThreadLast < vm::kThreadCount && gts::kPageLast < vm::kPageCount);

/// The code of GTS for "not supported by the firmware".
constexpr int16_t kNotSupported = 8;
/// The codes of GTS for "communication failed" and "the card cannot be opened" (GTS manual table
/// 3-1).
constexpr int16_t kNotOpen = -1;
constexpr int16_t kOpenFailed = -6;

constexpr std::string_view kResetCommands[] = {"GT_Reset"};

constexpr CardType kCardTypes[] = {
#define CARD_TYPE(name, axes) {name, axes, gts::kDefaults},
#include "gtcalls/gts/card_types.def"
};
/// Assumption: the card with 8 axes, to which the manual's bits of coordinate systems belong.
constexpr const CardType& kDefaultCard = kCardTypes[1];
static_assert(kDefaultCard.axis_count == motion::MotionConfig{}.axis_count);

constexpr int64_t kMillisecondUs = 1000;
/// Assumption: the time of one service of a slave on a bus.
constexpr int64_t kMailboxUs = 4000;

int64_t CostUs(const Command& command) {
  switch (command.cost) {
    case Cost::kMillisecond:
      return kMillisecondUs;
    case Cost::kMailbox:
      return kMailboxUs;
    case Cost::kNone:
    case Cost::kHostCall:
      break;
  }
  return HostCallUs(command);
}

FamilyState NewState() { return GtsState(); }

GtsState& StateIn(FamilyState& state) { return *std::get_if<GtsState>(&state); }

Result<void> RestoreMemory(std::string_view text, std::string_view path, FamilyState& state) {
  auto mram = gts::ParseMram(text, path);
  if (!mram.ok()) return mram.error();
  StateIn(state).mram = std::move(mram).value();
  return {};
}

void AfterTick(Card& card) {
  gts::WriteReachedValues(card);
  card.state<GtsState>().mram.Advance(card.motion.now());
}

}  // namespace

const Family& GtsFamily() {
  static const Family kFamily = {
      .name = "gts",
      .catalogue = GtsCatalogue(),
      .functions = gts::kFunctions,
      .not_supported = kNotSupported,
      .not_open = kNotOpen,
      .open_failed = kOpenFailed,
      .open_command = "GT_Open",
      .close_command = "GT_Close",
      .reset_commands = kResetCommands,
      .why_unsupported = gts::WhyUnsupported,
      .motion_role = gts::MotionRoleOf,
      .advised = {.drive_on = "GT_AxisOn",
                  .velocity = "GT_SetVel",
                  .clear_status = "GT_ClrSts",
                  .following_error_limit = "GT_SetPosErr",
                  .encoder_check = "GT_SetEncResponseCheck",
                  .gantry_error_limit = "GT_SetGantryErrLmt",
                  .append_segment = "GT_CrdData",
                  .buffered_move = "GT_BufMove",
                  .buffered_gear = "GT_BufGear",
                  .start_path = "GT_CrdStart",
                  .look_ahead = "GT_InitLookAhead",
                  .axis_look_ahead = "GT_InitLookAheadEx"},
      .finish = nullptr,
      .card_types = kCardTypes,
      .default_card = kDefaultCard,
      .cost_us = CostUs,
      .status_word = gts::StatusWord,
      .mode_number = gts::ModeNumber,
      .crds_of_mask = gts::CrdBitsOf,
      .new_state = NewState,
      .reset = [](FamilyState& state) { StateIn(state).Reset(); },
      .forget_program = [](FamilyState& state) { StateIn(state).plc.UnbindAll(); },
      .after_tick = AfterTick,
      .before_threads =
          [](Card& card) { card.state<GtsState>().plc.Evaluate(card.machine, card.motion); },
      .cycles_before_act =
          [](const CardView& card) {
            const GtsState& state = card.state<GtsState>();
            if (!state.plc.blocks.empty()) return int64_t{0};
            if (!state.mram.busy()) return kNeverActs;
            return state.mram.CyclesBeforeEnd(card.motion.now(), card.motion.config().cycle_us);
          },
      .writes_variables =
          [](const CardView& card) {
            return !card.state<GtsState>().plc.blocks.empty() || gts::WillWriteProgram(card.motion);
          },
      .memory_text =
          [](const FamilyState& state) {
            return gts::FormatMram(std::get_if<GtsState>(&state)->mram);
          },
      .restore_memory = RestoreMemory,
  };
  return kFamily;
}

}  // namespace oncard::gtcalls
