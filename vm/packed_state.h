// The state of a virtual machine in the memory that its program needs: a MachineState has room for
// 32 data pages, and most programs use a few. For owners of many states of one program.
// Tested by tests/vm/packed_state_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "vm/machine.h"

namespace oncard::vm {

/// The values of all variables. Equal variables are packed equally: a page with only zeros is one
/// that is not in use.
struct PackedVariables {
  std::vector<int64_t> slots;  ///< the globals, then the pages in use
  uint32_t used_pages = 0;     ///< bit n: page n is among them

  void Pack(const MachineState& state);
  /// Makes the variables of `state` equal to the packed ones.
  void Unpack(MachineState* state) const;
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
