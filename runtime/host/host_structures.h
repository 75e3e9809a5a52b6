// Converts the structures of a family's header to cells and back. The functions are generated with
// the header from the catalogue, so that the host's compiler determines the layout of members.
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

/// The 32-bit value, as on the card, of a host's long or unsigned long; empty if it does not fit.
constexpr std::optional<double> NarrowLong(int64_t bits, bool is_unsigned) {
  if (bits < std::numeric_limits<int32_t>::min() || bits > std::numeric_limits<uint32_t>::max()) {
    return std::nullopt;
  }
  const auto pattern = static_cast<uint32_t>(bits);
  return is_unsigned ? static_cast<double>(pattern)
                     : static_cast<double>(static_cast<int32_t>(pattern));
}

/// A host's long as a cell: a value that does not fit 32 bits is kept, and the command refuses it.
constexpr double LongCell(int64_t bits, bool is_unsigned) {
  return NarrowLong(bits, is_unsigned).value_or(static_cast<double>(bits));
}

/// A cell as a host's scalar. Values from commands fit; any other value is limited to the range of
/// the type, never undefined.
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

/// Bytes of a `long` of the header: those of the compiler's, or 4 in a library for declarations
/// that were written for Windows.
size_t LongSize();

/// Reads the scalars of the structure at `host`; `cells` has CellCount() elements.
void StructureToCells(const gtcalls::Structure& structure, const void* host,
                      std::span<double> cells);

/// Writes them; members that are not cells are not changed.
void StructureFromCells(const gtcalls::Structure& structure, std::span<const double> cells,
                        void* host);

/// The addresses of the arrays of the host to which the structure's pointers refer; `arrays` has an
/// element for each of gtcalls::ArraysOf().
void ArraysOfHost(const gtcalls::Structure& structure, const void* host, std::span<void*> arrays);

/// Bytes of one element of a host's array of them.
size_t StructureSize(const gtcalls::Structure& structure);

}  // namespace oncard::runtime
