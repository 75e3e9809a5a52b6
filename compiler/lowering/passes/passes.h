// Passes over the lowered statements of one function. None adds an access to a global, and none
// moves one past another. Each is in a file of its own.
#pragma once

#include <string_view>
#include <unordered_set>
#include <vector>

#include "compiler/lowering/ir.h"
#include "vm/fixed_point.h"

namespace oncard::compiler::lowering {

/// Computes a statement whose operands are constants, with the card's arithmetic.
bool FoldConstants(Instruction& instruction, int wrap_shift);

/// Replaces locals by what was assigned to them, up to the next label to which several ways lead,
/// and computes what becomes constant by that.
bool PropagateCopies(const Program& program, LoweredFunction& function, vm::DoubleFormat format);

/// Jumps to jumps, jumps to the next statement, jumps over jumps, and jumps to where the next goes.
bool ThreadJumps(const Program& program, LoweredFunction& function);

/// Decides comparisons with the number of a call (shared_bodies.cc) that can have one result only.
bool DecideWaysBack(LoweredFunction& function);

/// Replaces `number == 3` by the number itself where only 3 and 0 are possible. DecideWaysBack()
/// does not see what has been replaced, so this comes last.
bool ShortenWaysBack(LoweredFunction& function);

/// Removes statements that no path reaches, and labels without a jump.
bool RemoveUnreachable(LoweredFunction& function);

/// Removes labels without a jump.
void RemoveUnusedLabels(LoweredFunction& function);

/// Removes assignments to locals that are never read.
bool RemoveDeadStores(const Program& program, LoweredFunction& function);

/// The names of the globals and of the functions, for ShareTemporaries(). They belong to the
/// program.
std::unordered_set<std::string_view> SharedNames(const Program& program);

/// Lets temporaries with disjoint lifetimes share one, and gives them names that are not taken.
void ShareTemporaries(const std::unordered_set<std::string_view>& taken, Program& program,
                      LoweredFunction& function);

/// Lets locals whose lives do not overlap share slots, until `surplus` slots are free or no more
/// can.
void ShareSlots(int surplus, Program& program, LoweredFunction& function);

/// Gives an assert without a statement of its own before the next label a jump to that label: who
/// comes from elsewhere does not pass the assert. At the end of a function the printer adds a
/// statement.
void GiveStatementsToAsserts(LoweredFunction& function);

/// All optimising passes until nothing changes.
void Optimize(const Program& program, LoweredFunction& function, vm::DoubleFormat format);

/// Positions of the labels of a function, by number; -1 if it is not there.
std::vector<int> LabelPositions(const LoweredFunction& function);

/// True for a number that only its function can access.
bool IsLocalNumber(const Program& program, int variable);

}  // namespace oncard::compiler::lowering
