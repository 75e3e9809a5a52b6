// The differences between families of cards that the common code needs. This code uses the record
// only; it never checks which family it is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "base/message.h"
#include "base/result.h"
#include "gtcalls/card_type.h"
#include "gtcalls/catalogue.h"
#include "gtcalls/family_state.h"
#include "motion/motion_core.h"

namespace oncard::motion {
enum class ProfileMode : uint8_t;
}

namespace oncard::gtcalls {

struct Call;
struct Card;
struct CardView;

/// A function that executes one command. Returns 0, or the code of a refused command.
using CommandFunction = int16_t (*)(Call& call);

/// What a command means for the motions of single axes, for those who watch how programs use a
/// card.
enum class MotionRole : uint8_t {
  kNone,
  kTarget,       ///< sets where the next start leads; the first parameter is the profile
  kVelocity,     ///< sets how fast the next start moves; the same
  kCommit,       ///< starts the profiles of a mask with what has been set
  kAcknowledge,  ///< forgets why axes stopped: the first one and their number
};

/// The commands that messages about a card advise; empty for what cannot happen on the family's
/// cards.
struct AdvisedCommands {
  std::string_view drive_on = {};
  std::string_view velocity = {};
  std::string_view clear_status = {};  ///< forgets why an axis has stopped
  std::string_view following_error_limit = {};
  std::string_view encoder_check = {};
  std::string_view gantry_error_limit = {};
  std::string_view append_segment = {};
  std::string_view buffered_move = {};  ///< moves another axis during a path
  std::string_view buffered_gear = {};  ///< lets another axis follow a path
  std::string_view start_path = {};
  std::string_view look_ahead = {};
  std::string_view axis_look_ahead = {};  ///< the one that knows limits of each axis
};

/// Family::cycles_before_act of a card on which its family has nothing to do.
inline constexpr int64_t kNeverActs = std::numeric_limits<int64_t>::max();

/// The virtual time of a call from the host. GTS manual 10.2: a host calls at a fifth of the card's
/// rate; also the end of its chapter 7. Assumption: the same for families whose manuals name none.
constexpr int64_t HostCallUs(const Command& command) {
  constexpr int64_t kHostCallUs = 50;
  return command.cost == Cost::kNone ? 0 : kHostCallUs;
}

/// A family of cards. There is one constant object for each (gts/family.h).
struct Family {
  /// As in the names of its header and library: `gts`.
  std::string_view name;
  const Catalogue& catalogue;
  /// The function of each command, in the order of their numbers; nullptr if the card has none.
  std::span<const CommandFunction> functions;
  /// Return code of a command without a function.
  int16_t not_supported;
  /// Return code of a command for a card that is not open.
  int16_t not_open;
  /// Return code of the opening of a card that cannot be opened.
  int16_t open_failed;
  /// The commands with which a host opens and closes a card, and those with which it resets one.
  /// The host library executes them.
  std::string_view open_command;
  std::string_view close_command;
  std::span<const std::string_view> reset_commands;
  /// The reason why a command has no function; nullptr for commands of the host library.
  const Message* (*why_unsupported)(const Command& command) = [](const Command&) -> const Message* {
    return nullptr;
  };
  MotionRole (*motion_role)(const Command& command) = [](const Command&) {
    return MotionRole::kNone;
  };
  AdvisedCommands advised;
  /// Acts after every command that the card has been given, refused ones included, with its return
  /// code; returns the code that the caller gets. nullptr: the code is kept.
  int16_t (*finish)(Call& call, int16_t code);
  /// Its cards; the host library opens the default one unless a user names another.
  std::span<const CardType> card_types;
  const CardType& default_card;
  /// For a card whose commands count motion in cycles and not in milliseconds: what a cycle takes
  /// at power-on, in nanoseconds. Its motion core has cycles of 1 ms, whatever they take outside;
  /// Card::set_cycle_ns changes that. 0: a cycle takes what the configuration says, always.
  int64_t cycle_ns = 0;
  /// The virtual time of a call from the host, in microseconds.
  int64_t (*cost_us)(const Command& command) = HostCallUs;
  /// How many elements the arrays of a host have that a command with Passing::kHostMemory fills, as
  /// the card is now; nullptr: there is no such command.
  size_t (*array_elements)(const CardView& card) = nullptr;
  /// The status word of an axis, counted from 0, as the family's commands return it.
  uint32_t (*status_word)(const CardView& card, size_t axis);
  /// The number of a profile's mode, as the family's commands return it.
  int (*mode_number)(motion::ProfileMode mode);
  /// The coordinate systems that a mask of axes selects, on a card with that many axes: bit 0 is
  /// the first one.
  uint32_t (*crds_of_mask)(uint32_t mask, size_t axis_count) = [](uint32_t, size_t) {
    return uint32_t{0};
  };

  // The family's own state of a card, and its part of the card's cycle. What a family leaves out
  // does nothing.

  /// The state at power-on.
  FamilyState (*new_state)();
  /// The state after a reset of the card.
  void (*reset)(FamilyState& state);
  /// Clears what belongs to the program, because another one has been loaded.
  void (*forget_program)(FamilyState& state) = [](FamilyState&) {};
  /// Runs after the motion tick of each cycle.
  void (*after_tick)(Card& card) = [](Card&) {};
  /// Runs before the threads' statements of each cycle, after their delays have ended.
  void (*before_threads)(Card& card) = [](Card&) {};
  /// How many cycles can pass before one in which the two above have work: 0 if they have it in
  /// the next one, kNeverActs. Before, after_tick has only work after a tick in which a path
  /// reached commands for the owner of the core.
  int64_t (*cycles_before_act)(const CardView& card) = [](const CardView&) { return kNeverActs; };
  /// How many cycles pass at least until after_tick interrupts the host of the card (Card): 1 if it
  /// can do so in the next one, kNeverActs if it cannot before the next command. nullptr: the cards
  /// interrupt nobody.
  int64_t (*cycles_before_interrupt)(const CardView& card) = nullptr;
  /// True if variables of the program can still be written by something other than threads and the
  /// host.
  bool (*writes_variables)(const CardView& card) = [](const CardView&) { return false; };
  /// What survives that the card is switched off, as the text of a file.
  std::string (*memory_text)(const FamilyState& state) = [](const FamilyState&) {
    return std::string();
  };
  /// Puts it back into a card that is switched on. Fails, without a change, with the first line
  /// that is not as it must be; `path` is the file's name in the message.
  Result<void> (*restore_memory)(std::string_view text, std::string_view path, FamilyState& state) =
      [](std::string_view, std::string_view, FamilyState&) { return Result<void>(); };

  /// The configuration of a motion core for a card of that type; nullptr: of the default one.
  motion::MotionConfig Configured(motion::MotionConfig config,
                                  const CardType* type = nullptr) const {
    constexpr int64_t kCountedCycleUs = 1000;
    config.defaults = (type != nullptr ? *type : default_card).defaults;
    if (cycle_ns != 0) config.cycle_us = config.servo_us = kCountedCycleUs;
    return config;
  }
  /// What a cycle takes at power-on.
  int64_t CycleNs(const motion::MotionConfig& config) const {
    constexpr int64_t kNsPerUs = 1000;
    return cycle_ns != 0 ? cycle_ns : config.cycle_us * kNsPerUs;
  }
  /// True if its cards execute motion programs.
  bool HasPrograms() const {
    return std::ranges::any_of(catalogue.commands(), &Command::in_motion_program);
  }
  CommandFunction FunctionOf(const Command& command) const {
    return functions[command.number - 1u];
  }
  bool Resets(const Command& command) const {
    return std::ranges::find(reset_commands, command.name) != reset_commands.end();
  }
  /// True if the command has a function. Commands of the host library itself, such as GT_Open and
  /// GT_Download, have none.
  bool Executes(const Command& command) const { return FunctionOf(command) != nullptr; }
};

}  // namespace oncard::gtcalls
