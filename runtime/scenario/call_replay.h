// Gives a card the recorded calls of a host (call_record.h), one after the other, and compares what
// it answers with the record.
//
//   Controller controller(CardOptions(record.scenario));
//   SwitchOn(record, &controller);
//   auto replay = CallReplay::Create(record, controller.commands());
//   for (size_t i = 0; i < replay.size(); ++i) {
//     controller.AdvanceUs(replay.TimeUs(i) - controller.NowUs());
//     replay.Execute(i, &controller);
//   }
//
// Deterministic. Tested by tests/runtime/call_record_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "runtime/scenario/call_record.h"
#include "runtime/sim/controller.h"
#include "vm/image.h"

namespace oncard::runtime {

/// Puts a controller that was made with CardOptions() into the state in which the host opened it.
void SwitchOn(const CallRecord& record, Controller* controller);

class CallReplay {
 public:
  /// What a call has done.
  struct Done {
    /// As the call log writes it: `GT_GetFunId("add", pFunId) = 0`.
    Message text;
    int16_t code = 0;
    /// The card does not answer as it is recorded, and how.
    std::optional<Message> deviation;
  };

  /// Fails if a program of the record is damaged.
  static Result<CallReplay> Create(CallRecord record, const vm::CommandTable& commands);

  const CallRecord& record() const { return record_; }
  /// The programs that the host downloads, each as often as it does.
  const std::vector<std::shared_ptr<const vm::Image>>& programs() const { return programs_; }
  /// The calls, and the end of the record if it has one.
  size_t size() const { return record_.calls.size() + (record_.end ? 1 : 0); }
  /// When a call acts, in microseconds of the card.
  int64_t TimeUs(size_t number) const;
  /// The call with its inputs: `GT_Bind(0, 1, 0)`; the end: `GT_Close()`.
  std::string Describe(size_t number) const;
  /// Executes a call; the card's time must be TimeUs(). The end only compares.
  Done Execute(size_t number, Controller* controller) const;

 private:
  explicit CallReplay(CallRecord record) : record_(std::move(record)) {}

  Done ExecuteEnd(const Controller& controller) const;

  CallRecord record_;
  std::vector<std::shared_ptr<const vm::Image>> programs_;
  std::vector<std::shared_ptr<const vm::Image>> program_of_;  ///< by call; nullptr: it loads none
};

}  // namespace oncard::runtime
