// Calls of a function by itself with which it ends: `return gcd(b, a % b);`, also in a branch of
// `?:`, and in a void function the last statement of a way through it. The call that ends needs
// nothing any more, so its variables become those of the next one, and the call a jump to the
// beginning. Nothing is kept, and no depth is needed. A reference must stand for the same variable
// in both calls; where it begins there may change.
#include <algorithm>

#include "compiler/lowering/lowerer.h"
#include "compiler/tree_walk.h"

namespace oncard::compiler::lowering {
namespace {

// The parameter, or another name, in whose array an argument begins: p in `p + 1`; empty if it is
// none of the simple forms.
std::string_view RootOf(const Expression& argument) {
  const Expression* inner = &WithoutParens(argument);
  if (inner->kind == Expression::Kind::kUnary && inner->op == "&") {
    inner = &WithoutParens(*inner->operands[0]);
    if (inner->kind != Expression::Kind::kIndex) return {};
    inner = &WithoutParens(*inner->operands[0]);
  } else if (inner->kind == Expression::Kind::kBinary && (inner->op == "+" || inner->op == "-")) {
    inner = &WithoutParens(*inner->operands[0]);
  }
  return inner->kind == Expression::Kind::kName ? inner->text : std::string_view();
}

}  // namespace

// `return;` without an assert, which must hold each time.
bool Lowerer::EndsHere(const Statement& statement) const {
  return statement.kind == Statement::Kind::kReturn && statement.value == nullptr &&
         !asserts_.contains(&statement);
}

void Lowerer::FindTailCalls(FunctionInfo& info) {
  const std::vector<StatementPtr>& body = info.syntax->body;
  if (info.type.basic == BasicType::kVoid) AddLastOf(body, info);
  for (const StatementPtr& item : body) {
    ForEachStatement(*item, [&](const Statement& statement) {
      if (statement.kind == Statement::Kind::kReturn && statement.value != nullptr) {
        if (info.type.basic != BasicType::kVoid) AddTailCalls(*statement.value, info);
      }
      if (statement.kind == Statement::Kind::kBlock && !statement.items.empty() &&
          EndsHere(*statement.items.back())) {
        AddLastOf(statement.items, info);
      }
    });
  }
}

// The value that a function returns.
void Lowerer::AddTailCalls(const Expression& value, FunctionInfo& info) {
  const Expression& inner = WithoutParens(value);
  if (inner.kind == Expression::Kind::kConditional) {
    AddTailCalls(*inner.operands[1], info);
    AddTailCalls(*inner.operands[2], info);
    return;
  }
  if (inner.kind != Expression::Kind::kCall) return;
  const Expression& callee = WithoutParens(*inner.operands[0]);
  const bool itself = callee.kind == Expression::Kind::kName && callee.text == info.syntax->name;
  if (itself && KeepsReferences(inner, info)) info.tail_calls.insert(&inner);
}

void Lowerer::AddLastOf(const std::vector<StatementPtr>& items, FunctionInfo& info) {
  size_t count = items.size();
  while (count > 0 && EndsHere(*items[count - 1])) --count;
  if (count > 0) AddLast(*items[count - 1], info);
}

// The statement with which a void function ends.
void Lowerer::AddLast(const Statement& statement, FunctionInfo& info) {
  switch (statement.kind) {
    case Statement::Kind::kExpression: {
      const Expression& inner = WithoutParens(*statement.value);
      if (inner.kind == Expression::Kind::kCall) AddTailCalls(inner, info);
      return;
    }
    case Statement::Kind::kBlock:
      AddLastOf(statement.items, info);
      return;
    case Statement::Kind::kIf:
      AddLast(*statement.body, info);
      if (statement.else_body != nullptr) AddLast(*statement.else_body, info);
      return;
    default:
      return;
  }
}

// Whether the references of a call begin in the arrays of the parameters with the same names.
bool Lowerer::KeepsReferences(const Expression& call, const FunctionInfo& info) const {
  const std::vector<ParameterDeclaration>& parameters = info.syntax->parameters;
  for (size_t i = 0; i < parameters.size() && i + 1 < call.operands.size(); ++i) {
    const Declarator& declarator = parameters[i].declarator;
    if (!IsReference(declarator, ResolveGlobalType(parameters[i].specifiers))) continue;
    if (RootOf(*call.operands[i + 1]) != declarator.name) return false;
  }
  return true;
}

// Whether a tail call lets an array begin elsewhere.
bool Lowerer::MovesInTailCall(const FunctionInfo& info, size_t parameter) {
  return std::any_of(info.tail_calls.begin(), info.tail_calls.end(), [&](const Expression* call) {
    return parameter + 1 < call->operands.size() &&
           WithoutParens(*call->operands[parameter + 1]).kind != Expression::Kind::kName;
  });
}

bool Lowerer::IsTailCall(const Expression& expression) const {
  return frame_->info->tail_calls.contains(&expression);
}

// A returned value that is a tail call, or chooses one.
bool Lowerer::HasTailCall(const Expression& value) const {
  if (frame_->info->tail_calls.empty()) return false;
  const Expression& inner = WithoutParens(value);
  if (inner.kind != Expression::Kind::kConditional) return IsTailCall(inner);
  return HasTailCall(*inner.operands[1]) || HasTailCall(*inner.operands[2]);
}

void Lowerer::BeginBody() {
  const FunctionInfo& info = *frame_->info;
  if (info.tail_calls.empty()) return;
  frame_->begin_label = NewLabel(info.syntax->name, info.syntax->header, "again");
  EmitLabel(frame_->begin_label, info.syntax->header);
}

void Lowerer::LowerTailCall(const Expression& call) {
  const FunctionInfo& info = *frame_->info;
  const Function& syntax = *info.syntax;
  const auto known = ParametersOf(call, syntax);
  if (!known) return;
  const std::vector<const ParameterDeclaration*>& parameters = *known;
  std::vector<Argument> copies;
  for (size_t i = 0; i < parameters.size(); ++i) {
    const Expression& argument = *call.operands[i + 1];
    if (parameters[i]->declarator.name.empty()) {
      LowerEffect(argument);
      continue;
    }
    // What the parameter is in this call, whatever hides its name.
    const Symbol symbol = scopes_[frame_->scope_base].at(parameters[i]->declarator.name);
    if (symbol.invalid) return;
    if (symbol.is_reference) {
      const std::optional<ArrayPlace> array = LowerArray(argument);
      if (!array) return;
      if (array->variable != symbol.variable ||
          array->dimensions.size() != symbol.dimensions.size()) {
        Report(Code::kArrayArgument, argument.range, Source(argument.range), syntax.name,
               Source(parameters[i]->range));
        return;
      }
      if (array->offset == symbol.offset) continue;
      Value offset;
      offset.operand = LoadedOnce(array->offset, argument.range);
      copies.push_back({{symbol.offset, Type{}}, offset, argument.range, {}});
    } else if (symbol.type.own != nullptr) {
      const std::optional<ArrayPlace> structure = LowerStructure(argument);
      if (!structure) return;
      if (structure->element.own != symbol.type.own) {
        Report(Code::kArrayArgument, argument.range, Source(argument.range), syntax.name,
               Source(parameters[i]->range));
        return;
      }
      copies.push_back({{VariableOperand(symbol.variable), symbol.type},
                        {},
                        argument.range,
                        CopyOf(*structure, argument.range)});
    } else {
      Value value = LowerValue(argument);
      if (!RequireNumber(value, argument)) return;
      value = Convert(value, symbol.type.basic, argument.range);
      value.operand = LoadedOnce(value.operand, argument.range);
      copies.push_back(
          {{VariableOperand(symbol.variable), symbol.type}, value, argument.range, {}});
    }
  }
  Assign(copies);
  EmitGoto(frame_->begin_label, call.range);
}

}  // namespace oncard::compiler::lowering
