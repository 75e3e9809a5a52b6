// Host arguments as command arguments and back. Scalars travel as doubles, which hold every value
// of the interface exactly; what a pointer points to is copied into cells, one double per scalar,
// before the command and copied back after it. Memory of the host is accessed only after NULL and
// the number of elements have been checked. A structure of pointers to arrays that a command fills
// (Passing::kHostMemory) has a cell for each array, which says whether there is one, and then their
// elements.
//
// The vendor's `long` has 32 bits, the host's may have 64. A 64-bit value that is a sign-extended
// or zero-extended 32-bit pattern is taken as that pattern, so that 0x80000000 and 0xFFFFFFFF have
// the same meaning as in a 32-bit host; other values are out of range. Of masks and bit words only
// the lower 32 bits are used. Tested by tests/runtime/marshal_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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
  uint32_t with_cells = 0;  ///< bit n: argument n is a pointer to values, which are in its cells
  std::vector<double> cells;
};

/// Fills `call` from what the host passed; there is one host argument per parameter. `card`
/// determines how much memory pointers without a count cover; with NULL, for a card that is not
/// open, they cover nothing. All arguments are filled even on failure; those that cannot be read
/// are NULL. Fails with 7 on NULL where it is not allowed, a pointer that is not an address, a
/// count out of range, or a long that does not fit 32 bits.
Result<void> ReadArguments(const gtcalls::Command& command, std::span<const HostArgument> host,
                           const gtcalls::Card* card, MarshalledCall* call);

/// Copies the outputs of a command with this code to the host's memory: all of a command that
/// succeeded, and of one that was refused with 1 those that say why.
void WriteOutputs(const gtcalls::Command& command, const MarshalledCall& call, int16_t code);

}  // namespace oncard::runtime
