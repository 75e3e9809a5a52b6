// The structures of `gts.h` as cells and back. The functions are generated with `gts.h` from the
// catalogue, so that the host's compiler decides where a member lies.
//
// Cells are the scalars of a structure in the order of its members, nested structures and array
// elements one by one; text and pointers are not cells (gtcalls::CellCount()).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include "gtcalls/catalogue.h"

namespace oncard::runtime {

/// The number that a host's long or unsigned long stands for; empty when it has no 32 bits, which
/// are the card's.
constexpr std::optional<double> NarrowLong(int64_t bits, bool is_unsigned) {
  if (bits < std::numeric_limits<int32_t>::min() || bits > std::numeric_limits<uint32_t>::max()) {
    return std::nullopt;
  }
  const auto pattern = static_cast<uint32_t>(bits);
  return is_unsigned ? static_cast<double>(pattern)
                     : static_cast<double>(static_cast<int32_t>(pattern));
}

/// A host's long as a cell: one that has no 32 bits stays as it is, and the command refuses it.
constexpr double LongCell(int64_t bits, bool is_unsigned) {
  return NarrowLong(bits, is_unsigned).value_or(static_cast<double>(bits));
}

/// A cell as a host's scalar. Commands give values that fit; a value that does not is cut to the
/// type's range, never undefined.
template <typename T>
T FromCell(double value) {
  if constexpr (std::is_same_v<T, double>) {
    return value;
  } else {
    if (!(value > static_cast<double>(std::numeric_limits<T>::lowest()))) {
      return std::numeric_limits<T>::lowest();
    }
    if (value >= static_cast<double>(std::numeric_limits<T>::max())) {
      return std::numeric_limits<T>::max();
    }
    return static_cast<T>(value);
  }
}

/// Reads the scalars of the structure at `host`; `cells` has CellCount() elements.
void StructureToCells(const gtcalls::Structure& structure, const void* host,
                      std::span<double> cells);

/// Writes them; what is not a cell stays as it is.
void StructureFromCells(const gtcalls::Structure& structure, std::span<const double> cells,
                        void* host);

/// Bytes of one element of a host's array of them.
size_t StructureSize(const gtcalls::Structure& structure);

}  // namespace oncard::runtime
