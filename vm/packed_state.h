// The state of a virtual machine in the memory that its program needs: a MachineState has room for
// 32 data pages, and most programs use a few. For owners of many states of one program.
// Tested by tests/vm/packed_state_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "vm/machine.h"

namespace oncard::vm {

/// The values of all variables, without the zeros after the last one that is not 0. Equal variables
/// are packed equally: a page with only zeros is one that is not in use.
struct PackedVariables {
  /// The globals, then the pages in use: of each the number of slots that follow, and these.
  std::vector<int64_t> slots;
  uint32_t used_pages = 0;  ///< bit n: page n is among them

  void Pack(const MachineState& state);
  /// Makes the variables of `state` equal to the packed ones.
  void Unpack(MachineState* state) const;
  /// Those of the globals that are packed; the others are 0.
  std::span<const int64_t> Globals() const {
    return std::span(slots).subspan(1, static_cast<size_t>(slots.front()));
  }
};

class PackedState {
 public:
  explicit PackedState(const MachineState& state);

  /// Makes `state` equal to the packed one.
  void Unpack(MachineState* state) const;

 private:
  PackedVariables variables_;
  std::array<ThreadState, kThreadCount> threads_;
  SchedulerState scheduler_;
  int64_t executed_ = 0;
  int64_t faults_ = 0;
  int64_t cycle_ = 0;
};

}  // namespace oncard::vm
