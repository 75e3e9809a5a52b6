// The order of the passes.
#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {
namespace {

// Programs need two or three rounds, a value that goes through many branches one for each.
constexpr int kRoundMax = 64;

void Repeat(const Program& program, LoweredFunction& function, vm::DoubleFormat format) {
  bool changed = true;
  for (int round = 0; changed && round < kRoundMax; ++round) {
    changed = DecideWaysBack(function);
    changed |= PropagateCopies(program, function);
    changed |= FoldConstants(function, format);
    changed |= ThreadJumps(program, function);
    changed |= RemoveUnreachable(function);
    changed |= RemoveDeadStores(program, function);
  }
}

}  // namespace

void Optimize(const Program& program, LoweredFunction& function, vm::DoubleFormat format) {
  Repeat(program, function, format);
  if (ShortenWaysBack(function)) Repeat(program, function, format);
}

}  // namespace oncard::compiler::lowering
