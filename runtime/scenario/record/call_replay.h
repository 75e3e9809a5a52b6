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
#include <utility>
#include <vector>

#include "base/result.h"
#include "runtime/scenario/record/call_record.h"
#include "runtime/scenario/record/host_calls.h"
#include "runtime/sim/controller.h"
#include "vm/image.h"

namespace oncard::runtime {

/// Puts a controller that was made with CardOptions() into the state in which the host opened it.
void SwitchOn(const CallRecord& record, Controller* controller);

class CallReplay final : public HostCalls {
 public:
  /// Fails if a program of the record is damaged.
  static Result<CallReplay> Create(CallRecord record, const vm::CommandTable& commands);

  const CallRecord& record() const { return record_; }
  const std::vector<std::shared_ptr<const vm::Image>>& programs() const override {
    return programs_;
  }
  bool bare() const override { return record_.bare; }
  std::optional<Message> Incomplete() const override;
  size_t size() const override { return record_.calls.size() + (record_.end ? 1 : 0); }
  int64_t TimeUs(size_t number) const override;
  std::string Describe(size_t number) const override;
  bool ChangesCard(size_t number) const override;

 private:
  explicit CallReplay(CallRecord record) : record_(std::move(record)) {}

  Done Perform(size_t number, Controller* controller, bool described) const override;
  Done ExecuteEnd(const Controller& controller) const;
  /// The end as a call.
  std::string FormatClosing() const;

  CallRecord record_;
  std::vector<std::shared_ptr<const vm::Image>> programs_;
  std::vector<std::shared_ptr<const vm::Image>> program_of_;  ///< by call; nullptr: it loads none
};

/// The record of one card, ready for a run.
struct OpenedCalls {
  /// The beginning of one of the file's records.
  struct Opening {
    int card = 0;
    int opening = 1;
    size_t calls = 0;
  };

  Scenario scenario;  ///< the card and its surroundings
  std::unique_ptr<const HostCalls> calls;
  std::vector<RecordedSource> sources;  ///< of its programs, each once
  std::vector<Opening> openings;        ///< all in the file
};

/// Reads the text of a record and chooses one card of it. Fails as ParseCallRecords(),
/// ChooseCallRecord() and CallReplay::Create().
Result<OpenedCalls> OpenCallRecord(const std::string& text, const std::string& path,
                                   std::optional<int> card, int opening);

}  // namespace oncard::runtime
