// The order of the passes.
#include <algorithm>

#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {
namespace {

// Programs need two or three rounds; this many guard the time that a text can take.
constexpr int kRoundMax = 64;

void Repeat(const Program& program, LoweredFunction& function, vm::DoubleFormat format) {
  bool changed = true;
  for (int round = 0; changed && round < kRoundMax; ++round) {
    changed = DecideWaysBack(function);
    changed |= PropagateCopies(program, function, format);
    changed |= ThreadJumps(program, function);
    changed |= RemoveUnreachable(function);
    changed |= RemoveDeadStores(program, function);
  }
}

/// Numbers the variables of a function from 0 on, in their order, while passes run: their tables
/// are then as large as the function, and not as the program.
class OwnNumbers {
 public:
  OwnNumbers(const Program& program, LoweredFunction& function) : function_(function) {
    ForEachNumber([this](int& number) { numbers_.push_back(number); });
    std::sort(numbers_.begin(), numbers_.end());
    numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
    for (const int number : numbers_) {
      own_.variables.push_back(program.variables[static_cast<size_t>(number)]);
    }
    ForEachNumber([this](int& number) {
      const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), number);
      number = static_cast<int>(found - numbers_.begin());
    });
  }
  OwnNumbers(const OwnNumbers&) = delete;
  OwnNumbers& operator=(const OwnNumbers&) = delete;
  ~OwnNumbers() {
    ForEachNumber([this](int& number) { number = numbers_[static_cast<size_t>(number)]; });
  }

  /// Has only the variables of the function.
  const Program& program() const { return own_; }

 private:
  template <typename Visitor>
  void ForEachNumber(const Visitor& visit) {
    const auto visit_known = [&visit](int& number) {
      if (number >= 0) visit(number);
    };
    for (int& parameter : function_.parameters) visit_known(parameter);
    for (SharedCalls& calls : function_.calls) visit_known(calls.number);
    for (Instruction& instruction : function_.code) {
      ForEachOperand(instruction, [&visit_known](Operand& operand, bool /*written*/) {
        visit_known(operand.variable);
        visit_known(operand.index);
      });
    }
  }

  LoweredFunction& function_;
  std::vector<int> numbers_;  // in the program
  Program own_;
};

}  // namespace

void Optimize(const Program& program, LoweredFunction& function, vm::DoubleFormat format) {
  const OwnNumbers numbers(program, function);
  Repeat(numbers.program(), function, format);
  if (ShortenWaysBack(function)) Repeat(numbers.program(), function, format);
}

}  // namespace oncard::compiler::lowering
