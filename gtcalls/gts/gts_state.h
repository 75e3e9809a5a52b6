// The state of a GTS card in addition to its motion core and virtual machine: its own numbered
// variables, the ferroelectric memory, the PLC blocks and the settings of look-ahead. Plain data:
// copy it to keep it. Tested by tests/gtcalls/gts_state_test.cc.
#pragma once

#include <array>
#include <cstdint>

#include "gtcalls/gts/limits.h"
#include "gtcalls/gts/look_ahead_setup.h"
#include "gtcalls/gts/mram.h"
#include "gtcalls/gts/plc_blocks.h"

namespace oncard::gtcalls {

namespace gts {

/// Number of variables of GT_SetLongVar and GT_SetDoubleVar (assumption: 1024 each; the manuals
/// give no number).
inline constexpr int kUserVariableCount = kUserVariableLast + 1;

}  // namespace gts

struct GtsState {
  gts::Mram mram;
  std::array<int32_t, gts::kUserVariableCount> long_vars{};
  std::array<double, gts::kUserVariableCount> double_vars{};
  gts::PlcBlocks plc;
  std::array<gts::LookAheadSetup, motion::kCrdCount> look_ahead;

  /// GT_Reset: clears everything except the ferroelectric memory itself, whose buffer is cleared.
  void Reset();

  auto Fields(auto visit) const { return visit(mram, long_vars, double_vars, plc, look_ahead); }
};

}  // namespace oncard::gtcalls
