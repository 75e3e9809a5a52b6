// Where a command is called: a statement of a motion program, or a call of the host. Tested by
// tests/runtime/refused_commands_test.cc and supervisor_test.cc.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/message.h"
#include "gtcalls/card.h"
#include "vm/machine.h"

namespace oncard::runtime {

struct CommandPlace {
  int thread = vm::kHostCaller;
  // Of a thread's statement.
  std::string function;
  std::string file;  ///< of the source; `line` 0: not known
  int line = 0;
  // Of the host.
  std::string call;  ///< with its inputs: `GT_Update(0x4)`
};

/// The place of an instruction of the machine's program, for a thread that executes it.
CommandPlace PlaceOfInstruction(const vm::Machine& machine, int thread, int function,
                                int instruction);
/// The place of a call in progress.
CommandPlace PlaceOf(const gtcalls::Call& call);

/// `p.c:12: thread 0 f: `, the file relative to the program, or `GT_Update(0x4): `.
Message DescribePlace(const CommandPlace& place, const std::string& program_path);

/// ` (at 0.25 ms)`, ` (first at 0.25 ms, 3 times)`; nothing if the count is 0.
Message DescribeOccurrences(int64_t first_us, int64_t count);

/// Adds to what was found in some runs of a program what was found in others, each place once, with
/// the earliest time and all counts. The maps say where the finding of a place is in its list. What
/// is new comes last, in the order of its list.
template <typename Place, typename Found>
void IncludeFound(const std::map<Place, size_t>& other_places, const std::vector<Found>& others,
                  std::map<Place, size_t>* places, std::vector<Found>* all) {
  std::vector<const Place*> place_of(others.size());
  for (const auto& [place, number] : other_places) place_of[number] = &place;
  for (size_t i = 0; i < others.size(); ++i) {
    const auto [entry, added] = places->try_emplace(*place_of[i], all->size());
    if (added) {
      all->push_back(others[i]);
      continue;
    }
    Found& found = (*all)[entry->second];
    found.first_us = std::min(found.first_us, others[i].first_us);
    found.count += others[i].count;
  }
}

}  // namespace oncard::runtime
