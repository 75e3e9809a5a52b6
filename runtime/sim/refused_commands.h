// Refused commands of motion programs, each place of a program once. In the thread's status the
// next command overwrites the code; here it is kept. Not thread-safe. Tested by
// tests/runtime/refused_commands_test.cc.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "base/message.h"
#include "gtcalls/card.h"
#include "runtime/sim/command_place.h"

namespace oncard::runtime {

/// A statement whose command gave a code other than 0.
struct RefusedCommand {
  CommandPlace place;  ///< with the first thread that reached it
  Message call;        ///< `GT_AxisOn(9) = 7: parameter axis is 9; the range is [1, 8]`
  int16_t code = 0;
  int64_t first_us = 0;  ///< of the card's time
  int64_t count = 0;
};

class RefusedCommands {
 public:
  /// Records that a command of a motion-program thread was refused at that time.
  void Add(const gtcalls::Call& call, int16_t code, int64_t now_us);

  /// Adds what was recorded in other runs of the same program, behind what there is.
  void Include(const RefusedCommands& other);

  /// In the order of their first occurrence.
  const std::vector<RefusedCommand>& list() const { return list_; }

 private:
  /// Program, function, instruction and code, and the position in the list.
  std::map<std::tuple<uint64_t, int, int, int16_t>, size_t> known_;
  std::vector<RefusedCommand> list_;
};

/// `p.c:12: thread 0 f: GT_AxisOn(9) = 7: ...`, the file relative to the program.
Message DescribeRefusedPlace(const RefusedCommand& refused, const std::string& program_path);
/// The same with ` (first at 0.25 ms, 3 times)`.
Message DescribeRefusedCommand(const RefusedCommand& refused, const std::string& program_path);

}  // namespace oncard::runtime
