// PLC blocks: small functions bound to program variables and evaluated once per profile cycle,
// before the threads. A block reads inputs or variables and writes a variable or an output:
//
//   Di       variable := input              Do     output := variable
//   timer    variable := delayed(input)     Flank  variable := 1 for one cycle after an edge
//   counter  variable := compare(count)     Srff   variable := set/reset flip-flop
//
// An evaluation works like a PLC scan: first all Di blocks, then timers, counters, flanks and
// flip-flops in the order in which they were bound, then all Do blocks. A variable reads as true
// when it is not 0 and is written as 0 or 1.
//
// It also holds the functions received so far by a download by words. The vendor's header names the
// structures and constants; what the members mean is assumed from their names
// (docs/assumptions.md). Tested by tests/gtcalls/plc_blocks_test.cc.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "motion/motion_core.h"
#include "vm/machine.h"

namespace oncard::gtcalls::gts {

/// thread number of a block whose variables are globals.
inline constexpr int kGlobalVariables = -1;

/// Assumption: the vendor's header gives no limit.
inline constexpr size_t kPlcBlockMax = 256;

/// Sizes of the download by words: all functions together, and one GT_LoadPlcCommand call.
inline constexpr size_t kPlcWordMax = 4096;
inline constexpr int kPlcWordsPerCall = 24;

/// TBindDi: variable := input, or its complement.
struct DiBlock {
  motion::DiType type = motion::DiType::kGpi;
  int16_t bit = 0;  ///< from 0
  bool reverse = false;

  auto Fields(auto visit) const { return visit(type, bit, reverse); }
};

/// TBindDo: output := variable, or its complement.
struct DoBlock {
  motion::DoType type = motion::DoType::kGpo;
  int16_t bit = 0;  ///< from 0
  bool reverse = false;

  auto Fields(auto visit) const { return visit(type, bit, reverse); }
};

/// Which change of the input a timer delays; numbered as PLC_TIMER_TT, _TF, _TTF.
enum class TimerType : uint8_t { kOnDelay = 0, kOffDelay = 1, kBoth = 2 };

/// TBindTimer: variable follows the input; a delayed change must last `delay_us` first.
struct TimerBlock {
  TimerType type = TimerType::kOnDelay;
  uint16_t input = 0;
  int64_t delay_us = 0;
  bool output = false;
  bool pending = false;    ///< the input differs from the output
  int64_t elapsed_us = 0;  ///< since it was first seen to differ

  auto Fields(auto visit) const {
    return visit(type, input, delay_us, output, pending, elapsed_us);
  }
};

/// Edges of a variable; numbered as PLC_COUNTER_EDGE_* and PLC_FLANK_*.
enum class Edge : uint8_t { kUp = 0, kDown = 1, kBoth = 2 };

/// When a counter's variable is 1; numbered as PLC_COUNTER_EQ, _LE, _GE.
enum class CounterType : uint8_t { kEqual = 0, kLessEqual = 1, kGreaterEqual = 2 };

/// TBindCounter: counts edges of the input; variable := count compared with the target.
struct CounterBlock {
  CounterType type = CounterType::kEqual;
  Edge edge = Edge::kUp;
  int32_t init = 0;
  int32_t target = 0;
  /// The count wraps around in [begin, end]; it is unlimited if they are equal.
  int32_t begin = 0;
  int32_t end = 0;
  bool down = false;
  uint32_t unit = 1;  ///< edges per count
  uint16_t input = 0;
  /// Variable that holds the count at `init` while it is not 0; -1 = none.
  int16_t reset = -1;
  int32_t count = 0;
  uint32_t unit_count = 0;  ///< edges since the last count
  bool last_input = false;

  auto Fields(auto visit) const {
    return visit(type, edge, init, target, begin, end, down, unit, input, reset, count, unit_count,
                 last_input);
  }
};

/// TBindFlank: variable := 1 for the one cycle in which the input has changed.
struct FlankBlock {
  Edge edge = Edge::kUp;
  uint16_t input = 0;
  bool last_input = false;

  auto Fields(auto visit) const { return visit(edge, input, last_input); }
};

/// TBindSrff: 1 once the set variable was not 0, 0 once the reset variable was; reset wins.
struct SrffBlock {
  uint16_t set = 0;
  uint16_t reset = 0;
  bool output = false;

  auto Fields(auto visit) const { return visit(set, reset, output); }
};

using PlcFunction = std::variant<DiBlock, DoBlock, TimerBlock, CounterBlock, FlankBlock, SrffBlock>;

/// A block and its variable. The variables of a block lie in the data page that its thread uses at
/// the time of the evaluation, or among the globals.
struct PlcBlock {
  int16_t thread = kGlobalVariables;
  uint16_t variable = 0;
  PlcFunction function;

  auto Fields(auto visit) const { return visit(thread, variable, function); }
};

/// One function received by words (GT_LoadPlc, GT_LoadPlcCommand).
struct WordFunction {
  int16_t id = 0;  ///< from 1
  vm::DataType return_type = vm::DataType::kInt;
  std::vector<uint16_t> words;  ///< records as in a `.bin` file

  auto Fields(auto visit) const { return visit(id, return_type, words); }
};

/// All PLC blocks of a card. Plain data: copy it to keep it.
struct PlcBlocks {
  std::vector<PlcBlock> blocks;         ///< in the order they were bound
  std::vector<WordFunction> functions;  ///< received by words, ascending ids
  /// `functions` has changed since it last became the program.
  bool functions_pending = false;

  /// Adds a block. A variable has one writing block and an output one Do block: a block that writes
  /// the same target as an older one replaces it. False when there is no room.
  bool Bind(const PlcBlock& block);
  /// Removes the blocks of a thread (or of the globals).
  void Unbind(int thread);
  /// Removes all blocks, for a new program. Received words are kept.
  void UnbindAll() { blocks.clear(); }

  /// One evaluation; call it once per profile cycle, between the motion tick and the threads.
  /// Blocks of unbound threads are not evaluated.
  void Evaluate(vm::Machine& machine, motion::MotionCore& motion);

  auto Fields(auto visit) const { return visit(blocks, functions, functions_pending); }
};

}  // namespace oncard::gtcalls::gts
