// What a lowered program takes on the card, and whether the card has that much.
#pragma once

#include <vector>

#include "compiler/lowering/ir.h"
#include "compiler/lowering/lowering.h"
#include "compiler/reporter.h"

namespace oncard::compiler::lowering {

/// What a variable takes of a page, or of the globals.
int SlotsOf(const Variable& variable);

/// Of a function whose temporaries have been shared.
FunctionCost CostOf(const Program& program, const LoweredFunction& function);

/// Slots of all globals.
int GlobalSlots(const Program& program);

/// Reports what is more than the card has, with the variables that take most. The costs are those
/// of the functions in their order.
void CheckLimits(const Program& program, const std::vector<FunctionCost>& costs,
                 Reporter& reporter);

}  // namespace oncard::compiler::lowering
