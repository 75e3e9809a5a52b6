// The names that C has for the variables of the lowered program: given to the symbols of its
// object, and replaced in its comments `//@`. Tested by tests/compiler/lowering_test.cc.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/lowering/ir.h"
#include "vm/object.h"

namespace oncard::compiler::lowering {

/// Gives symbols of the variables of the program with the given numbers their names in C.
void WriteNames(const Program& program, const std::vector<int>& variables,
                std::vector<vm::Symbol>* symbols);

/// A line `//@` with the names of the lowered program instead of those of C. The name of a local,
/// behind `pageN.`, stays if the thread functions have different variables for it.
std::string NameAsLowered(const Program& program, std::string_view comment);

}  // namespace oncard::compiler::lowering
