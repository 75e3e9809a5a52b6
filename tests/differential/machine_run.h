// Executes random programs with oncard: compiler, linker, machine.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "compiler/compiler.h"
#include "oracle.h"
#include "random_program.h"
#include "vm/command_table.h"
#include "vm/image.h"
#include "vm/machine.h"

namespace oncard::differential {

/// A card without commands, because the random programs call none.
class NoCommands final : public vm::CommandTable {
 public:
  const vm::CommandShape* Find(uint16_t) const override { return nullptr; }
  int16_t Execute(uint16_t, vm::Machine&, int, std::span<vm::CommandArgument>) override {
    return 0;
  }
};

/// Compiles text under the name `random.c`; includes are not found.
compiler::Compilation CompileSource(const std::string& text, vm::DoubleFormat format);

/// The errors of a compilation, one per line.
std::string ErrorsOf(const compiler::Compilation& compilation);

/// The compiled and linked program. The error contains the first diagnostics.
Result<std::shared_ptr<const vm::Image>> CompileAndLink(const RandomProgram& program);

/// Number of statements after which a program is assumed to be endless.
inline constexpr int64_t kEndless = 1'000'000;

/// One execution of a random program: function k on thread k and data page k.
class MachineRun {
 public:
  /// Loads the program and sets all variables to their initial values.
  MachineRun(const RandomProgram& program, std::shared_ptr<const vm::Image> image);

  /// Runs the functions one after the other, with at most `chunk` statements per call of the
  /// machine. False if one does not end.
  bool RunInSequence(int64_t chunk);
  /// Runs the functions as threads. False if they do not end.
  bool RunInterleaved(const Interleaving& interleaving);
  /// Final values in the order of RunOracle().
  Values FinalValues() const;
  uint64_t Hash() const { return machine_.Hash(); }
  /// Statements executed.
  int64_t executed() const { return machine_.state().executed; }

 private:
  vm::SlotAddress Address(int function, const Declaration::Slot& slot) const;
  void Initialise(int function, const std::vector<Declaration>& declarations);
  void Collect(int function, const std::vector<Declaration>& declarations, Values* values) const;

  NoCommands commands_;
  vm::Machine machine_;
  const RandomProgram& program_;
};

}  // namespace oncard::differential
