// How the card's language writes the operands and statements of a lowered program.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "compiler/lowering/ir.h"

namespace oncard::compiler::lowering {

class Speller {
 public:
  /// The program must outlive the speller.
  explicit Speller(const Program& program) : program_(program) {}

  /// From now on a constant of Program::constants is written by its name.
  void UseName(int constant) { named_.insert(constant); }

  std::string Spell(const Operand& operand) const;
  std::string Spell(const Instruction& instruction, const LoweredFunction& function) const;
  /// What an assert names: `x`, `a[3]`.
  std::string SpellName(const Instruction& assert, size_t argument) const;

 private:
  const Variable& VariableAt(int number) const {
    return program_.variables[static_cast<size_t>(number)];
  }
  std::string MemberOf(const Operand& operand) const;
  std::string SpellUnary(const Instruction& instruction) const;

  const Program& program_;
  std::set<int> named_;
};

/// The name of a variable's type.
std::string_view SpellType(const Variable& variable);

/// As motion programs spell it: the shortest decimal fraction with this raw value.
std::string SpellDouble(int64_t raw);

}  // namespace oncard::compiler::lowering
