// Refused commands of a host program and of the motion programs of its cards: for the host, each
// command and reason of a card once with its first call; for motion programs, each place. And what
// the supervisors of its cards have found. `oncard exec` requests the list with ONCARD_REFUSALS; it
// is printed when the host ends. Thread-safe.
// Tested by tests/tools/exec_command_test.cc.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

#include "base/message.h"
#include "runtime/observe/supervisor.h"
#include "runtime/sim/call_text.h"
#include "runtime/sim/refused_commands.h"

namespace oncard::runtime {

/// The values of ONCARD_REFUSALS.
enum class RefusalReport : uint8_t {
  kNothing,
  kWarn,   ///< `warn`: the list is printed
  kStrict  ///< `strict`: the entries of the list are failures
};

RefusalReport RefusalReportOfProcess();

/// So many reasons are told apart for each command and code of a card; reasons with values in them
/// can be without number.
inline constexpr size_t kRefusalReasons = 8;

class HostRefusals {
 public:
  static HostRefusals& OfProcess();

  /// Records a refused call of the host.
  void Add(const LoggedCall& call);
  /// Records the refused commands of a card's motion programs.
  void AddProgram(int card, const std::vector<RefusedCommand>& refused);
  /// Records what the supervisor of a card has found, but for the warnings that ONCARD_SILENT
  /// switches off: `no-NAME`, separated by commas.
  void AddFindings(int card, const std::vector<CardFinding>& findings);
  /// `card 0: GT_AxisOn(9) = 7: ... (first at 0.25 ms, 3 times)`, then `card 0: p.c:12: thread 0 f:
  /// ...`, each in the order of the first calls. After kRefusalReasons reasons: `card 0: GT_AxisOn
  /// = 7 for other reasons (first at 2 ms, 40 times)`.
  std::vector<Message> Describe();

 private:
  struct Refusal {
    int card = 0;
    Message call;
    int64_t first_us = 0;
    int64_t count = 0;
  };

  /// A reason, and the position in the list; the last of kRefusalReasons + 1 is for all others.
  struct Reason {
    std::string text;
    size_t position = 0;
  };
  /// What a call is refused for, in the list; nullptr if it is new.
  Refusal* Find(const LoggedCall& call, std::vector<Reason>* reasons);

  std::mutex mutex_;
  /// By card, command and code.
  std::map<std::tuple<int, uint16_t, int16_t>, std::vector<Reason>> known_;
  std::vector<Refusal> list_;
  std::vector<Message> of_programs_;
};

}  // namespace oncard::runtime
