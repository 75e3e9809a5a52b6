// The number of elements that a pointer covers where it depends on the state of the card: positions
// of a coordinate system, capture offsets. The host library queries it before it accesses the
// host's memory. Tested by tests/runtime/marshal_test.cc.
#pragma once

#include <cstddef>

#include "gtcalls/card.h"
#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

/// Axes of a coordinate system (from 1); 0 when it has not been set up, or for a number that no
/// coordinate system has.
size_t CrdDimension(const Card& card, double crd);

/// Elements behind a pointer parameter without a count: one, or for the parameters that say
/// per_dimension or per_offset as many as the card has now. `first` is the command's first
/// argument.
size_t ElementsOnCard(const Parameter& parameter, const Card& card, double first);

/// Number of cells for one element of a pointer parameter: one, or one per scalar of the structure.
size_t CellsPerElement(const Parameter& parameter);

}  // namespace oncard::gtcalls
