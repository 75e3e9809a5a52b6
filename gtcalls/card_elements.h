// The number of elements that a pointer covers where it depends on the state of the card: positions
// of a coordinate system, capture offsets. The host library queries it before it accesses the
// host's memory. Tested by tests/runtime/marshal_test.cc.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "gtcalls/card.h"
#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

/// Axes of a coordinate system (from 1); 0 when it has not been set up, or for a number that no
/// coordinate system has.
size_t CrdDimension(const Card& card, double crd);

/// Elements behind a pointer parameter without a count: one, or as many as the card has now if it
/// counts them. `first` is the command's first argument.
size_t ElementsOnCard(const Parameter& parameter, const Card& card, double first);

/// Elements behind a pointer parameter of a call: as many as another argument says, else as above;
/// nothing if that argument is out of its range, in which case the host library refuses the call.
/// Without a card those that it counts are 0.
std::optional<size_t> ElementsBehind(const Command& command, const Parameter& parameter,
                                     std::span<const vm::CommandArgument> arguments,
                                     const Card* card);

/// Number of cells for one element of a pointer parameter: one, or one per scalar of the structure;
/// of Passing::kHostMemory one per array.
size_t CellsPerElement(const Parameter& parameter);

/// The cells of an argument with Passing::kHostMemory, for the command that fills the arrays. The
/// first of its elements says of each array whether there is one.
class HostArrays {
 public:
  HostArrays(std::span<double> cells, const Parameter& parameter)
      : cells_(cells), arrays_(CellsPerElement(parameter)) {}

  size_t arrays() const { return arrays_; }
  /// The number of elements of each.
  size_t elements() const { return cells_.size() / arrays_ - 1; }
  /// True if the host has passed the address of an array.
  bool given(size_t array) const { return cells_[array] != 0; }
  /// The command does not fill it: the host's array stays as it is.
  void LeaveOut(size_t array) { cells_[array] = 0; }
  void Set(size_t array, size_t element, double value) {
    cells_[(element + 1) * arrays_ + array] = value;
  }

 private:
  std::span<double> cells_;
  size_t arrays_;
};

}  // namespace oncard::gtcalls
