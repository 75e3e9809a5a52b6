// A call of a GT command in words, for logs and lists:
//
//   12.250 card0 GT_GetVarValue(-1, {id=0, dataType=1}, pValue, 1) = 0, pValue=[5050]
//   12.300 card0 GT_Bind(40, 1, 0) = 7: parameter thread is 40; the range is [0, 31]
//   12.500 card0 thread 3: GT_Update(0x1) = 1: axis 1 is not in Trap mode
//   13.000 card0: axis 1 passed its positive soft limit 2000 at 2012.5: ...
//
// The card's virtual time in milliseconds when the command acted, the card, the thread when a
// motion program was refused a command, the call with its inputs (masks and bit words in hex; an
// output shows its parameter's name), the code, after a refusal the reason, after a success the
// outputs. Lines for what a card does by itself have no call. docs/host-api.md describes the format
// for users. Tested by tests/runtime/call_log_test.cc.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/message.h"
#include "gtcalls/catalogue.h"
#include "vm/command_table.h"

namespace oncard::runtime {

/// The data of one call in the log.
struct LoggedCall {
  int64_t time_us = 0;
  int card = 0;
  int caller = vm::kHostCaller;  ///< the host, or the thread of the motion program
  const gtcalls::Command& command;
  std::span<const vm::CommandArgument> arguments;
  int16_t code = 0;
  const Message& reason;
};

/// A call with its inputs, its code and the reason: `GT_Bind(40, 1, 0) = 7: parameter thread is 40;
/// ...`.
std::string FormatCallAndCode(const gtcalls::Command& command,
                              std::span<const vm::CommandArgument> arguments, int16_t code,
                              const Message& reason, Language language);

/// A call with its inputs: `GT_Bind(40, 1, 0)`.
std::string FormatInputs(const gtcalls::Command& command,
                         std::span<const vm::CommandArgument> arguments);

/// What a call has written: `, pValue=[5050]`.
std::string FormatOutputs(const gtcalls::Command& command,
                          std::span<const vm::CommandArgument> arguments);

/// Appends the line of a call, without its end.
void AppendCall(const LoggedCall& call, Language language, std::string* line);

/// Appends the line of something that a card did by itself, without its end.
void AppendEvent(int64_t time_us, int card, const Message& what, Language language,
                 std::string* line);

/// Takes note of calls, and of what cards do by themselves. A card that has one writes to it while
/// it runs.
class CardLog {
 public:
  virtual ~CardLog() = default;
  virtual void Write(const LoggedCall& call) = 0;
  /// Logs something that a card did by itself.
  virtual void Write(int64_t time_us, int card, const Message& what) = 0;
};

}  // namespace oncard::runtime
