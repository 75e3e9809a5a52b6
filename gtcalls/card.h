// A card as commands see it: the virtual machine, the motion core and the state of its family, and
// the common calling convention of commands from the host and from motion programs.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "base/result.h"
#include "gtcalls/family.h"
#include "gtcalls/family_state.h"
#include "motion/motion_core.h"
#include "vm/machine.h"

namespace oncard::gtcalls {

/// A card for those who only look at it.
struct CardView {
  const Family& family;
  const motion::MotionCore& motion;
  const FamilyState& family_state;

  template <typename State>
  const State& state() const {
    return *std::get_if<State>(&family_state);
  }
  /// The status word of an axis, whose number counts from 0.
  uint32_t StatusWord(size_t axis) const { return family.status_word(*this, axis); }
  /// The number of the mode of a profile, which itself counts from 0.
  int ModeNumber(size_t profile) const { return family.mode_number(motion.profile(profile).mode); }
};

/// The parts of the card that a command may use. Owned by the runtime's controller.
struct Card {
  const Family& family;
  vm::Machine& machine;
  motion::MotionCore& motion;
  FamilyState& family_state;
  /// Reads the files that commands name; empty: they are read from the file system.
  std::function<Result<std::string>(const std::string& path)> read_file = {};
  /// Changes what a cycle of the card takes outside, from the next cycle on; only in families with
  /// Family::cycle_ns. Set by the card's owner.
  std::function<void(int64_t cycle_ns)> set_cycle_ns = {};
  /// Interrupts the host of the card, now that a tick has passed: what the call log says of it. Set
  /// by the card's owner.
  std::function<void(const Message& what)> interrupt_host = {};
  /// Why the description of its bus cannot be used; empty: it can, or there is none.
  Message bus_error = {};

  CardView view() const { return {family, motion, family_state}; }
  /// The state of the family that the command belongs to.
  template <typename State>
  State& state() const {
    return *std::get_if<State>(&family_state);
  }
};

/// A call in progress.
struct Call {
  const Command& command;
  Card& card;
  int caller = vm::kHostCaller;  ///< thread number, or kHostCaller
  std::span<vm::CommandArgument> arguments;
  /// Why the command was refused, for the call log; with code 0 it holds remarks.
  Message reason;
  /// The same in the bits of the family's command register, for Family::finish; 0: not said.
  uint16_t cause = 0;
  /// The function has no result yet (WaitForTick()).
  bool waits = false;
  /// It has waited, and is asked again.
  bool ticked = false;

  double value(size_t index) const { return arguments[index].value; }
  int integer(size_t index) const { return static_cast<int>(arguments[index].value); }
  bool given(size_t index) const { return !arguments[index].null; }
  /// The data of the pointer argument `index`, one double per scalar.
  std::span<double> cells(size_t index) const { return arguments[index].cells; }
  /// Stores an output when its pointer is not NULL.
  void Set(size_t index, double result, size_t cell = 0) const {
    if (!arguments[index].null) arguments[index].cells[cell] = result;
  }
  /// Records the reason and returns the code.
  int16_t Refuse(int16_t code, Message why) {
    reason = std::move(why);
    return code;
  }
  /// For a command that ends when the next cycle of the card has passed: its function returns this,
  /// and is called again after the tick, with `ticked`. For commands of hosts only.
  int16_t WaitForTick() {
    waits = true;
    return vm::kOk;
  }
  /// Adds a remark to a command that succeeds.
  void Note(const Message& remark) {
    if (!reason.en.empty()) reason = {reason.en + "; ", reason.zh + "；"};
    reason = {reason.en + remark.en, reason.zh + remark.zh};
  }
};

/// Checks NULL pointers and the catalogue's ranges (7), then executes the family's function. A
/// refused command changes nothing. If the call waits afterwards, it has no code yet: it is to be
/// given to ResumeCommand() after the next tick, again as long as it waits.
int16_t ExecuteCommand(Call& call);
int16_t ResumeCommand(Call& call);

/// Sees each command that a card executes for a host or a motion program. It must not change the
/// card.
class CommandObserver {
 public:
  CommandObserver() = default;
  CommandObserver(const CommandObserver&) = delete;
  CommandObserver& operator=(const CommandObserver&) = delete;
  virtual ~CommandObserver() = default;

  virtual void BeforeCommand(const Call& call) = 0;
  /// `code` is that which the caller gets; other than 0, the command has changed nothing.
  virtual void AfterCommand(const Call& call, int16_t code) = 0;
};

/// Receives each refused command of a motion-program thread, with its code.
using RefusalObserver = std::function<void(const Call& call, int16_t code)>;

/// The virtual machine's view of the family's catalogue, bound to one card.
class CardCommands final : public vm::CommandTable {
 public:
  /// The card must outlive this object.
  explicit CardCommands(Card* card) : card_(card) {}

  /// Programs see only a code; the observer also receives the reason. An empty observer ends this.
  void ObserveRefusals(RefusalObserver observer) { refusals_ = std::move(observer); }

  /// From now on shows the observer all commands; nullptr ends this. It must exist until then.
  void ObserveCommands(CommandObserver* observer) { observer_ = observer; }

  /// Runs before every command: brings the card to the present. An empty function ends this.
  void PrepareWith(std::function<void()> prepare) { prepare_ = std::move(prepare); }

  const vm::CommandShape* Find(uint16_t number) const override;
  int64_t Elements(uint16_t number, size_t parameter, double first) const override;
  int16_t Execute(uint16_t number, vm::Machine& machine, int thread,
                  std::span<vm::CommandArgument> arguments) override;
  /// Executes a call of the card's host or of a thread, as ExecuteCommand(), and shows it.
  int16_t Execute(Call& call);
  /// The same for ResumeCommand().
  int16_t Resume(Call& call);

 private:
  Card* card_;
  CommandObserver* observer_ = nullptr;
  RefusalObserver refusals_;
  std::function<void()> prepare_;
};

}  // namespace oncard::gtcalls
