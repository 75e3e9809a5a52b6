// Constant tables move from the globals to the page of the only thread function that reads them,
// where there are more globals than the card has: the largest first, until the others fit. A page
// is not cleared when a thread starts, so the function begins with writing all values of the table.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "compiler/lowering/costs.h"
#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {
namespace {

// Of the globals that EmitStart() adds.
constexpr int kStartSlots = 4;

// The thread functions that use each variable.
std::map<int, std::set<size_t>> UsersOf(const std::vector<LoweredFunction>& functions) {
  std::map<int, std::set<size_t>> users;
  for (size_t i = 0; i < functions.size(); ++i) {
    for (const Instruction& instruction : functions[i].code) {
      ForEachOperand(instruction, [&users, i](const Operand& operand, bool /*written*/) {
        if (operand.variable >= 0) users[operand.variable].insert(i);
      });
    }
  }
  return users;
}

}  // namespace

void Lowerer::MoveTables() {
  int surplus = GlobalSlots(program_) - lowering_options_.slots;
  if (!initial_values_.empty()) surplus += kStartSlots;
  if (surplus <= 0 || !lowering_options_.optimize) return;
  const std::map<int, std::set<size_t>> users = UsersOf(program_.functions);
  const auto slots = [this](int table) {
    return SlotsOf(program_.variables[static_cast<size_t>(table)]);
  };
  std::vector<int> tables;
  for (const auto& [variable, functions] : users) {
    const Variable& info = program_.variables[static_cast<size_t>(variable)];
    if (info.is_table && functions.size() == 1) tables.push_back(variable);
  }
  std::stable_sort(tables.begin(), tables.end(),
                   [&slots](int a, int b) { return slots(a) > slots(b); });
  for (const int table : tables) {
    if (surplus <= 0) return;
    surplus -= slots(table);
    MoveTable(table, program_.functions[*users.at(table).begin()]);
  }
}

void Lowerer::MoveTable(int table, LoweredFunction& function) {
  Variable& variable = program_.variables[static_cast<size_t>(table)];
  variable.role = Variable::Role::kLocal;
  function.tables.push_back(table);
  std::erase(program_.globals, table);
  std::vector<Operand> values(static_cast<size_t>(variable.size),
                              ConstantOperand(variable.type, 0));
  std::erase_if(initial_values_, [table, &values](const InitialValue& initial) {
    if (initial.target.variable != table) return false;
    values[static_cast<size_t>(initial.target.value)] = initial.value;
    return true;
  });
  std::vector<Instruction> body = std::exchange(function.code, {});
  out_ = &function;
  BeginFullExpression(variable.range);
  for (size_t i = 0; i < values.size(); ++i) {
    EmitCopy(ElementOperand(table, static_cast<int64_t>(i)), values[i], variable.range);
  }
  function.code.insert(function.code.end(), std::make_move_iterator(body.begin()),
                       std::make_move_iterator(body.end()));
  out_ = nullptr;
}

}  // namespace oncard::compiler::lowering
