// The structures of `gts.h` as cells and back. The functions are generated with `gts.h` from the
// catalogue, so that the host's compiler decides where a member lies.
//
// Cells are the scalars of a structure in the order of its members, nested structures and array
// elements one by one; text and pointers are not cells (gtcalls::CellCount()).
#pragma once

#include <cstddef>
#include <span>

#include "gtcalls/catalogue.h"

namespace oncard::runtime {

/// Reads the scalars of the structure at `host`; `cells` has CellCount() elements.
void StructureToCells(const gtcalls::Structure& structure, const void* host,
                      std::span<double> cells);

/// Writes them; what is not a cell stays as it is.
void StructureFromCells(const gtcalls::Structure& structure, std::span<const double> cells,
                        void* host);

/// Bytes of one element of a host's array of them.
size_t StructureSize(const gtcalls::Structure& structure);

}  // namespace oncard::runtime
