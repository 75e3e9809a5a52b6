// Executes random programs with g++, the oracle: writes the programs into one C++ file after
// oracle_prelude.h, compiles and runs it, and returns the final value of every variable.
// Tests that try a part of their programs (RandomPart) ask for all: the answer for a text is kept
// in build/oracle for every build.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "random_program.h"

namespace oncard::differential {

/// How the functions of an interleaved program run: function k on thread k.
struct Interleaving {
  std::string order;  ///< threads of the first statements, as digits; ended ones are skipped
  int quantum = 1;    ///< then round robin with this number of statements per turn
};

/// Final values: for each function its parameters and locals in order of declaration, the result
/// and the fault; then the globals.
using Values = std::vector<int64_t>;

/// Compiles and runs all programs in `folder`, which is created. The functions of sequential
/// programs run one after the other. With `interleavings`, one for each program, they run as
/// threads. The error contains the output of g++.
Result<std::vector<Values>> RunOracle(const std::vector<RandomProgram>& programs,
                                      const std::vector<Interleaving>& interleavings,
                                      const std::string& folder);

/// Compiles a source in `folder`, which is created, with `flags`, which select the language, and
/// runs it. Every line of its output is a list of numbers.
Result<std::vector<Values>> RunOracle(const std::string& text, const std::string& flags,
                                      const std::string& folder);

/// A name for each of the Values of a program.
std::vector<std::string> ValueNames(const RandomProgram& program);

}  // namespace oncard::differential
