// The record of what a host program did to a card: its calls with their inputs, the instants at
// which they acted and their codes, with the contents of the files that they named, and the card's
// surroundings. A card that is given the same calls at the same instants does the same without the
// host (call_replay.h).
//
// A record is a text with one JSON object in each line, for all cards of a host; docs/host-api.md
// describes it. Any text is safe to read. Tested by tests/runtime/call_record_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "gtcalls/family.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/sim/call_text.h"
#include "vm/object.h"

namespace oncard::runtime {

/// How the name of a record ends.
inline constexpr std::string_view kCallRecordEnding = ".calls";

/// A source of a program that the host downloaded.
struct RecordedSource {
  std::string path;  ///< where it was when the host downloaded the program
  std::string text;
};

/// One call of the host.
struct RecordedCall {
  struct Argument {
    double value = 0;
    bool null = false;          ///< a pointer: the host passed NULL
    bool unread = false;        ///< an input pointer: the call was refused before it was read
    std::vector<double> cells;  ///< what an input pointer refers to
    std::string text;           ///< of a name
  };

  int64_t time_us = 0;  ///< of the card, when the call acted
  const gtcalls::Command* command = nullptr;
  std::vector<Argument> arguments;  ///< one for each parameter
  int16_t code = 0;
  /// The call was given to the card; otherwise the host library answered it.
  bool acts = true;
  Message reason;                          ///< unless it acts: why the call was refused
  std::optional<vm::ObjectFiles> program;  ///< that the call has loaded
  std::vector<RecordedSource> sources;     ///< of `program`, as far as they were found
  std::optional<std::string> config;       ///< the file that the call has read
};

/// The calls from one opening of a card to its closing.
struct CallRecord {
  struct End {
    int64_t time_us = 0;
    uint64_t hash = 0;  ///< Controller::Hash()
  };

  int card = 0;
  const gtcalls::Family* family = nullptr;  ///< of the card
  int opening = 1;    ///< the first, second ... time that the host opened the card
  Scenario scenario;  ///< the card and its surroundings
  bool bare = false;  ///< the host ran without a scenario: the card has no surroundings
  std::vector<RecordedCall> calls;
  /// Missing if the record ends before: the host was killed, or the file was cut.
  std::optional<End> end;
};

/// A call with what it was given, without `program`, `sources` and `config`.
RecordedCall RecordCall(const LoggedCall& call, bool acts);

// The lines of a record, each with its end.

/// The first line of the file.
std::string FormatRecordHead();
/// A card is opened. Of the scenario only the card and, unless it is bare, its world are kept.
std::string FormatRecordedOpening(int card, const Scenario& scenario, bool bare);
/// Appended to a text, which a host with millions of calls uses again for each.
void AppendRecordedCall(int card, const RecordedCall& call, std::string* text);
std::string FormatRecordedEnd(int card, const CallRecord::End& end);

/// Reads the records of all cards, in the order of their numbers, then of their openings; at least
/// one. `path` is the file's name in messages. Fails with the first line that is not as it must be.
Result<std::vector<CallRecord>> ParseCallRecords(std::string_view text, const std::string& path);

/// One of them; without `card` that of the lowest number. Fails if there is no such opening.
Result<CallRecord> ChooseCallRecord(std::vector<CallRecord> records, std::optional<int> card,
                                    int opening);

}  // namespace oncard::runtime
