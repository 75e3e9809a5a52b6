// The cards of this process: the only state that a host library keeps outside its controllers.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "runtime/host/call_recorder.h"
#include "runtime/host/host_api.h"
#include "runtime/host/host_clock.h"
#include "runtime/host/host_memory.h"
#include "runtime/host/host_scenario.h"
#include "runtime/host/marshal.h"
#include "runtime/observe/supervisor.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// What a call has read from files.
struct RecordedFiles {
  std::optional<vm::ObjectFiles> program;
  std::vector<RecordedSource> sources;
  std::optional<std::string> config;
};

/// The entry of one card number. `mutex` guards everything that is not atomic and is held during a
/// whole call.
struct CardSlot {
  std::mutex mutex;
  std::unique_ptr<Controller> controller;  ///< nullptr while the card is not open
  std::optional<HostClock> clock;          ///< set while the card is open
  std::optional<CardWatch> watch;          ///< set while the card is open and there is a scenario
  /// The virtual time before which the scenario cannot be over (0: at any moment): who sleeps locks
  /// no card until then.
  std::atomic<int64_t> earliest_end_ns = INT64_MAX;
  /// The code of commands that need a program while there is none: that of the download that
  /// failed, or 1 if there was no download.
  int16_t no_program_code = 1;
  std::optional<CardMemory> memory;  ///< set while the card is open and has a file for it
  RefusedCommands refused;  ///< refused commands of motion programs since the card was opened
  std::optional<Supervisor> supervisor;  ///< set while the card is open and warnings are wanted
  MarshalledCall call;                   ///< arguments of the call in progress
  CallRecorder* recorder = nullptr;      ///< set while the card is open and its calls are recorded
  std::optional<RecordedFiles> files;    ///< that the call in progress has read

  /// Lets an open card catch up with the time of its host, including a call that takes `cost_us`.
  void CatchUp(int64_t cost_us);
  /// The same for a card whose interrupts are awaited: takes note of the time, then lets it pass up
  /// to the next interrupt. True if there is one.
  void NoteTime();
  bool AdvanceToInterrupt();
  /// True if noted time has not passed yet.
  bool late() const { return late_us_ > 0; }
  /// The virtual time at which an open card can interrupt its host; VirtualTime::kNeverNs.
  int64_t EarliestInterruptNs() const;
  /// Lets an open card reach its next tick, or the end of its scenario, with its host.
  void PassTick();
  /// Sets `earliest_end_ns`. A reset, after which the time of an open card begins anew, only makes
  /// the end later.
  void FindEarliestEnd();
  /// Closes the card if it is open, after it has caught up to at most the end of its scenario.
  void SwitchOff();

 private:
  void Advance(int64_t passed_us);
  bool over() const { return watch && watch->over(); }

  int64_t late_us_ = 0;  ///< noted and not yet passed
};

struct CardTable {
  std::array<CardSlot, kCardCount> slots;
  std::atomic<int> selected = 0;  ///< the card of the single-card header

  /// The cards of this process.
  static CardTable& OfProcess();
};

}  // namespace oncard::runtime
