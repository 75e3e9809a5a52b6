// What random structured programs compute: compiled by gcc, and run on the machine after they have
// become programs of the card.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "machine_run.h"
#include "structured_program.h"
#include "vm/object.h"

namespace oncard::differential {

/// One C file with all programs, each of which prints its result and its globals.
std::string StructuredOracleText(const std::vector<StructuredProgram>& programs);

/// The same values from a run of the program's object; empty if it does not end.
Values RunStructured(const StructuredProgram& program, const vm::Object& object);

/// What the first function of an object returns, and globals after it (StructuredProgram::globals);
/// empty if it does not end within so many statements.
Values RunFirstFunction(const vm::Object& object, const std::vector<std::string>& globals,
                        int64_t statements);

/// How often a run of the program reads and writes globals.
int64_t CountGlobalAccesses(const vm::Object& object);

}  // namespace oncard::differential
