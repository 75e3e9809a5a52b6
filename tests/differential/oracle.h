// Executes random programs by way of g++, the oracle: programs are written into one C++ file behind
// oracle_prelude.h, which is compiled and run; every variable's final value comes back.
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
  int quantum = 1;    ///< afterwards round robin with so many statements a turn
};

/// Final values: per function its parameters and locals in order of declaration, the result and
/// the fault; then the globals.
using Values = std::vector<int64_t>;

/// Compiles and runs all programs in `folder`, which is created. Sequential programs run their
/// functions one after the other. With `interleavings`, one for each program, they run as threads.
/// The error holds what g++ said.
Result<std::vector<Values>> RunOracle(const std::vector<RandomProgram>& programs,
                                      const std::vector<Interleaving>& interleavings,
                                      const std::string& folder);

/// Compiles a source with `flags`, which name the language, in `folder`, which is created, and runs
/// it. Every line that it prints is a list of numbers.
Result<std::vector<Values>> RunOracle(const std::string& text, const std::string& flags,
                                      const std::string& folder);

/// One name for each of the Values of a program.
std::vector<std::string> ValueNames(const RandomProgram& program);

}  // namespace oncard::differential
