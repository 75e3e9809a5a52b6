// Host arguments as command arguments and back. Scalars travel as doubles, which hold every value
// of the interface exactly; what a pointer points to is copied into cells, one double per scalar,
// before the command and copied back after it. Memory of the host is touched only after NULL and
// the number of elements have been checked.
//
// The vendor's `long` has 32 bits, ours may have 64. A 64-bit value that is a 32-bit pattern
// extended with or without its sign is taken for that pattern, so that 0x80000000 and
// 0xFFFFFFFF mean what they mean to a 32-bit host; other values are out of range. Of masks and bit
// words the lower 32 bits count.
// Tested by tests/runtime/marshal_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/result.h"
#include "gtcalls/card.h"
#include "gtcalls/catalogue.h"
#include "runtime/host/host_api.h"
#include "vm/command_table.h"

namespace oncard::runtime {

/// The arguments of one call in the form commands take. `cells` keeps its memory between calls.
struct MarshalledCall {
  std::array<vm::CommandArgument, gtcalls::kParameterMax> arguments;
  std::vector<double> cells;
};

/// Fills `call` from what the host passed; there is one host argument per parameter. `card` says
/// how much memory the pointers cover that have no count; NULL for a card that is not open, which
/// makes them cover nothing. All arguments are filled even on failure, those that cannot be read as
/// NULL. Fails with 7 on NULL where it is not allowed, a pointer that is no address, a count out of
/// range, or a long that is no 32-bit number.
Result<void> ReadArguments(const gtcalls::Command& command, std::span<const HostArgument> host,
                           const gtcalls::Card* card, MarshalledCall* call);

/// Copies the outputs to the host's memory.
void WriteOutputs(const gtcalls::Command& command, const MarshalledCall& call);

/// Doubles that one element behind a pointer parameter takes: one, or one per scalar of the
/// structure.
size_t CellsPerElement(const gtcalls::Parameter& parameter);

}  // namespace oncard::runtime
