// The card's supervisor: watches a card as a motion engineer would, and warns of what succeeds but
// cannot be meant (card_warnings.def), each place of a program and each call of a host once.
//
// It looks at the commands that the card executes and at what the card reports by itself, not at
// cycles, so it costs nothing while nothing happens. It never changes the card. What it has to
// remember of a run, and what it has found, are values. Both can be put back with a state of the
// card; who looks at many runs puts back the first one only.
//
// Deterministic; not thread-safe. Tested by tests/runtime/supervisor_test.cc.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "base/message.h"
#include "runtime/observe/card_warnings.h"
#include "runtime/sim/command_place.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// Something to warn of.
struct CardFinding {
  CardWarning warning;
  CommandPlace place;
  Message text;
  int64_t first_us = 0;  ///< of the card's time
  int64_t count = 0;     ///< 0: it belongs to the end of the run
  bool at_end = false;   ///< only the end of the run shows it
};

/// `p.c:12: thread 0 f: axis 1 ...`, the file relative to the program, and `[drive-off]`.
Message DescribeFindingPlace(const CardFinding& finding, const std::string& program_path);
/// The same with ` (first at 0.25 ms, 3 times)` before the name.
Message DescribeFinding(const CardFinding& finding, const std::string& program_path);

class Supervisor final : public CardObserver {
 public:
  /// What has happened on a card so far.
  struct History;
  using HistoryPointer = std::shared_ptr<History>;  ///< shared: it is copied before a change
  /// What it has found so far.
  struct Found;
  using FoundPointer = std::shared_ptr<Found>;  ///< the same

  /// Watches the controller from now on; it must exist as long as this object.
  explicit Supervisor(Controller* controller);
  ~Supervisor() override;

  /// In the order of their first occurrence. Who reports them leaves out what is silenced.
  const std::vector<CardFinding>& findings() const;
  /// Adds what was found in other runs of the same program, behind what there is.
  void Include(const Supervisor& other);
  /// To be called at the end of a run that was not interrupted: adds what only the end shows.
  void JudgeEnd();
  /// Takes that back: the run goes on.
  void ForgetEnd();

  /// What it remembers of the present run, to be put back with a state of the card.
  HistoryPointer history() const { return history_; }
  void PutBack(HistoryPointer history) { history_ = std::move(history); }
  /// What it remembers as numbers: equal ones for what it cannot tell apart.
  static void AddTo(const HistoryPointer& history, std::vector<int64_t>* words);
  /// The profiles of which it remembers that values are set, but not taken over: a start of others
  /// looks at them. Bit 0 is the first one.
  static uint32_t AwaitedProfiles(const HistoryPointer& history);
  /// True if it looks at these when the command is executed.
  bool LooksAround(const gtcalls::Command& command) const {
    return KindOf(command).role == gtcalls::MotionRole::kCommit;
  }
  /// What it has found up to now, to be put back likewise.
  FoundPointer found() const { return found_; }
  void PutBack(FoundPointer found) { found_ = std::move(found); }

  void BeforeCommand(const gtcalls::Call& call) override;
  void AfterCommand(const gtcalls::Call& call, int16_t code) override;
  void Happened(const motion::CardEvent& event) override;
  void Overran(int thread) override;
  void Reset() override;

 private:
  /// A call that may have to be named later.
  struct CallSite;
  /// What is known of a command.
  struct CommandKind {
    gtcalls::MotionRole role = gtcalls::MotionRole::kNone;
    bool moves = false;  ///< it may start motions
  };

  /// To look at: a core that can be changed would leave its lanes.
  const motion::MotionCore& core() const { return controller_.motion(); }
  /// The history, to be changed.
  History& Present();
  /// What was found, to be changed.
  Found& PresentFound();
  CommandKind KindOf(const gtcalls::Command& command) const { return kinds_[command.number - 1u]; }
  CallSite SiteOf(const gtcalls::Call& call) const;
  CommandPlace PlaceOfSite(const CallSite& site) const;

  void NoteSetUp(const gtcalls::Call& call, gtcalls::MotionRole role);
  /// True if a call and an earlier one are of two threads, and that of the earlier one has not
  /// ended.
  bool OfTwoThreads(const gtcalls::Call& call, const CallSite& earlier) const;
  /// A target is set while the one of another thread is not started yet.
  void CheckTarget(const gtcalls::Call& call, size_t profile);
  /// A start changes where an axis goes that moves for another thread.
  void CheckChange(const gtcalls::Call& call, size_t profile);
  /// Profiles begin to move, or would begin if they had a velocity.
  void NoteStart(const gtcalls::Call& call, uint32_t profiles);
  void NoteAcknowledged(const gtcalls::Call& call);
  void NoteCommit(const gtcalls::Call& call);
  void NoteLeftOut(const gtcalls::Call& call, uint32_t mask);
  void CheckMask(const gtcalls::Call& call, uint32_t mask);
  void CheckVelocity(const gtcalls::Call& call, size_t profile);
  void CheckDrive(const gtcalls::Call& call, size_t profile);
  /// True if the profile has values that a start would make it move to.
  bool AwaitsStart(size_t profile) const;
  /// The profiles that move.
  uint32_t Moving() const;

  void Add(CardWarning warning, const gtcalls::Call& call, Message text);
  /// The same for one of the axes that the call concerns.
  void Add(CardWarning warning, const gtcalls::Call& call, size_t axis, Message text);
  /// Warning, program, function, instruction, and the call of a host.
  using Key = std::tuple<CardWarning, uint64_t, int, int, std::string>;
  Key KeyOf(CardWarning warning, const CallSite& site) const;
  /// The same for each axis that the call started.
  Key KeyOf(CardWarning warning, const CallSite& site, size_t axis) const;
  CardFinding& Add(Key key, CommandPlace place, Message text, int64_t at_us);
  /// An axis begins to move beyond what its drive can follow.
  void NoteBeyondLimit(const motion::CardEvent& event);
  Message DescribeDriveOff(size_t axis) const;
  /// A path begins to move an axis whose drive is off.
  void NoteMovedByPath(const motion::CardEvent& event);
  void JudgeStop(size_t axis);
  void JudgeLeftOut(size_t profile);
  void JudgeWorkLeft();

  Controller& controller_;
  std::vector<CommandKind> kinds_;  ///< by the numbers of commands
  HistoryPointer history_;
  FoundPointer found_;
  uint32_t moving_before_ = 0;  ///< the command that is being executed
};

}  // namespace oncard::runtime
