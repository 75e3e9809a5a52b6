// Calls of the program's own functions, and of abs and fabs. The statements of a function are
// inserted where it is called, unless shared_bodies.cc lets them stand once.
#include <fmt/core.h>

#include <algorithm>

#include "compiler/lowering/lowerer.h"
#include "compiler/tree_walk.h"
#include "vm/limits.h"

namespace oncard::compiler::lowering {

Value Lowerer::LowerMagnitude(const Expression& call, bool real) {
  if (call.operands.size() != 2) {
    Report(Code::kArgumentCount, call.range, real ? "fabs" : "abs", int64_t{1},
           static_cast<int64_t>(call.operands.size()) - 1);
    return {};
  }
  const Value value = LowerValue(*call.operands[1]);
  if (!RequireNumber(value, *call.operands[1])) return {};
  const BasicType type = real ? BasicType::kDouble : BasicType::kInt;
  return Compute(real ? vm::UnaryOperator::kFabs : vm::UnaryOperator::kAbs,
                 Convert(value, type, call.range).operand, type, call.range);
}

Value Lowerer::LowerCall(const Expression& expression) {
  const Value nothing = {Operand(), BasicType::kVoid, BasicType::kVoid};
  const Expression& callee = WithoutParens(*expression.operands[0]);
  const Symbol* symbol = Lookup(callee.text);
  if (symbol == nullptr) {
    if (callee.text == "abs" || callee.text == "fabs") {
      return LowerMagnitude(expression, callee.text == "fabs");
    }
    if (const gtcalls::Command* command = options_.catalogue->Find(callee.text)) {
      LowerCommand(expression, *command);
      return nothing;
    }
    Report(Code::kNotACommand, callee.range, callee.text);
    return {};
  }
  if (symbol->kind != Symbol::Kind::kFunction) {
    if (!symbol->invalid) {
      Report(Code::kNotLowered, callee.range, MakeMessage("a call of a variable", "对变量的调用"),
             MakeMessage("there are no pointers to functions", "没有函数指针"));
    }
    return {};
  }
  if (symbol->function->syntax->prototype) {
    Report(Code::kNoBody, expression.range, callee.text);
    return {};
  }
  return LowerOwnCall(expression, *symbol->function);
}

// Whether a function moves its parameter: `p++`, `p += 2`, `p = q`.
bool Lowerer::IsMoved(std::string_view name, const Function& function) {
  using Kind = Expression::Kind;
  bool moved = false;
  const auto in_expression = [&](const Expression& expression) {
    const bool changes = expression.kind == Kind::kPostfix || expression.kind == Kind::kAssign ||
                         expression.kind == Kind::kCompound || expression.kind == Kind::kUnary;
    if (!changes || (expression.kind == Kind::kUnary && expression.op.size() != 2)) return;
    const Expression& target = WithoutParens(*expression.operands[0]);
    moved |= target.kind == Kind::kName && target.text == name;
  };
  for (const StatementPtr& item : function.body) {
    ForEachStatement(*item, [&](const Statement& statement) {
      ForEachWholeExpression(
          statement, [&](const Expression& whole) { ForEachExpression(whole, in_expression); });
    });
  }
  return moved;
}

// A parameter, by its number, that stands for what its argument names in the caller. In a function
// that calls itself its place is a variable if it is not always the same.
std::optional<Lowerer::Symbol> Lowerer::BindReference(const ParameterDeclaration& parameter,
                                                      size_t number, const Expression& argument,
                                                      const FunctionInfo& info) {
  const Declarator& declarator = parameter.declarator;
  const Type type = ResolveGlobalType(parameter.specifiers);
  std::optional<ArrayPlace> array = LowerArray(argument);
  std::optional<std::vector<int64_t>> dimensions = Dimensions(declarator, type);
  if (!array || !dimensions) return std::nullopt;
  const bool same_rows =
      array->dimensions.size() == dimensions->size() &&
      std::equal(dimensions->begin() + 1, dimensions->end(), array->dimensions.begin() + 1);
  if (!same_rows || array->element.basic != type.basic || array->element.own != type.own) {
    Diagnostic* const diagnostic =
        Report(Code::kArrayArgument, argument.range, Source(argument.range), info.syntax->name,
               Source(parameter.range));
    const bool whole = array->dimensions.empty() && array->element.own == type.own;
    if (diagnostic != nullptr && whole) {
      AddNote(*diagnostic, MakeMessage("pass its address: '&{0}'", "请传递其地址：'&{0}'",
                                       Source(argument.range)));
    }
    return std::nullopt;
  }
  // How many elements there are is that of the argument.
  dimensions->front() = array->dimensions.front();
  Symbol symbol;
  symbol.type = type;
  symbol.type.rows = nullptr;
  symbol.type.is_const |= array->element.is_const;
  symbol.range = declarator.name_range;
  symbol.is_reference = true;
  symbol.dimensions = std::move(*dimensions);
  symbol.variable = array->variable;
  symbol.offset = Stable(array->offset, argument.range);
  const Variable& variable = program_.variables[static_cast<size_t>(symbol.variable)];
  if (IsRecursive(info) && variable.group == info.group) {
    Report(Code::kNotLowered, argument.range,
           MakeMessage("a reference to '{0}', of which each call of '{1}' has its own",
                       "对 '{0}' 的引用，'{1}' 的每次调用各有一份", Source(argument.range),
                       info.syntax->name),
           MakeMessage("make it static or global, or return the value",
                       "请改为 static 或全局变量，或返回该值"));
    return std::nullopt;
  }
  const bool begins_there = symbol.offset.IsConstant() && symbol.offset.value == 0;
  symbol.moves = IsMoved(declarator.name, *info.syntax) || MovesInTailCall(info, number);
  if (info.group != 0 && variable.size == 0) {
    symbol.moves |= !begins_there;
  } else if (info.group != 0) {
    symbol.moves |= !symbol.offset.IsConstant() || !PassesNames(info, number);
  }
  if (symbol.moves && variable.size == 0) {
    Report(Code::kNotLowered, argument.range,
           MakeMessage("moving '{0}' away from a number", "把 '{0}' 从一个数移开", declarator.name),
           MakeMessage("pass an array", "请传递数组"));
    return std::nullopt;
  }
  return symbol;
}

// Where an array begins is that before the call, also if the function changes the variable that
// says it: `f(&a[i], &i)`.
void Lowerer::KeepOffsets(Scope& scope, SourceRange range) {
  std::vector<Symbol*> references;
  for (auto& [name, symbol] : scope) {
    if (symbol.is_reference) references.push_back(&symbol);
  }
  std::sort(references.begin(), references.end(),
            [](const Symbol* a, const Symbol* b) { return a->range.begin < b->range.begin; });
  for (Symbol* symbol : references) {
    const bool changes =
        std::any_of(references.begin(), references.end(), [&](const Symbol* other) {
          const int leaf = symbol->offset.variable - other->variable;
          return symbol->offset.IsVariable() && leaf >= 0 && leaf < LeavesOf(other->type);
        });
    if (!changes) continue;
    const Operand kept = NewTemporary(vm::DataType::kInt, range);
    EmitCopy(kept, symbol->offset, range);
    symbol->offset = kept;
  }
}

// The parameters that a call gives values to; empty if it has another number of arguments.
std::optional<std::vector<const ParameterDeclaration*>> Lowerer::ParametersOf(
    const Expression& call, const Function& syntax) {
  std::vector<const ParameterDeclaration*> parameters;
  for (const ParameterDeclaration& parameter : syntax.parameters) {
    const bool nothing = parameter.declarator.name.empty() && HasWord(parameter.specifiers, "void");
    if (!nothing) parameters.push_back(&parameter);
  }
  if (parameters.size() == call.operands.size() - 1) return parameters;
  Diagnostic* diagnostic =
      Report(Code::kArgumentCount, call.range, syntax.name, static_cast<int64_t>(parameters.size()),
             static_cast<int64_t>(call.operands.size()) - 1);
  if (diagnostic != nullptr) {
    AddNote(*diagnostic, syntax.name_range, MakeMessage("it is defined here", "其定义在此"));
  }
  return std::nullopt;
}

// Gives the parameters their values. All arguments are computed before the first is assigned.
bool Lowerer::BindArguments(const Expression& call, const FunctionInfo& info, Scope& scope) {
  const Function& syntax = *info.syntax;
  const auto known = ParametersOf(call, syntax);
  if (!known) return false;
  const std::vector<const ParameterDeclaration*>& parameters = *known;
  std::vector<Argument> copies;
  bool good = true;
  for (size_t i = 0; i < parameters.size(); ++i) {
    const Declarator& declarator = parameters[i]->declarator;
    const Expression& argument = *call.operands[i + 1];
    const Type type = ResolveGlobalType(parameters[i]->specifiers);
    Symbol symbol;
    symbol.type = type;
    symbol.range = declarator.name_range;
    symbol.offset = IntOperand(0);
    if (IsReference(declarator, type)) {
      std::optional<Symbol> reference = BindReference(*parameters[i], i, argument, info);
      if (!reference) return false;
      symbol = std::move(*reference);
      if (symbol.moves) {
        // Where it is now.
        Value offset;
        offset.operand = symbol.offset;
        symbol.offset = VariableOperand(VariableOf(
            parameters[i], Variable::Role::kLocal,
            fmt::format("{}_{}", syntax.name, declarator.name), Type{}, {}, declarator.name_range));
        symbol.dimensions.front() = 0;
        copies.push_back({{symbol.offset, Type{}}, offset, argument.range, {}});
      }
    } else if (type.own != nullptr) {
      const std::optional<ArrayPlace> structure = LowerStructure(argument);
      if (!structure || !IsComplete(type, declarator.name, declarator.name_range)) return false;
      if (structure->element.own != type.own) {
        Report(Code::kArrayArgument, argument.range, Source(argument.range), syntax.name,
               Source(parameters[i]->range));
        return false;
      }
      symbol.variable = VariableOf(parameters[i], Variable::Role::kLocal,
                                   fmt::format("{}_{}", syntax.name, declarator.name), type, {},
                                   declarator.name_range);
      copies.push_back({{VariableOperand(symbol.variable), type}, {}, argument.range, structure});
    } else {
      Value value = LowerValue(argument);
      if (!RequireNumber(value, argument)) {
        good = false;
        continue;
      }
      value = Convert(value, type.basic, argument.range);
      symbol.variable = VariableOf(parameters[i], Variable::Role::kLocal,
                                   fmt::format("{}_{}", syntax.name, declarator.name), type, {},
                                   declarator.name_range);
      copies.push_back({{VariableOperand(symbol.variable), type}, value, argument.range, {}});
    }
    if (!declarator.name.empty()) scope.emplace(declarator.name, std::move(symbol));
  }
  KeepOffsets(scope, call.range);
  if (info.group != 0) {
    for (Argument& copy : copies) {
      OwnByFrames(copy.place.operand.variable, copy.place.type, info.group);
      // The arguments may be parameters of the same function, which are assigned one by one.
      if (!IsRecursive(info) || copies.size() == 1) continue;
      if (copy.structure) {
        *copy.structure = CopyOf(*copy.structure, copy.range);
      } else {
        copy.value.operand = LoadedOnce(copy.value.operand, copy.range);
      }
    }
    BeginFrame(info, call.range);
  }
  Assign(copies);
  return good;
}

void Lowerer::Assign(const std::vector<Argument>& arguments) {
  for (const Argument& argument : arguments) {
    const Place& place = argument.place;
    if (argument.structure) {
      CopyStructure(StructureAt(place.operand.variable, place.type), *argument.structure,
                    argument.range);
    } else {
      Store(place, argument.value, argument.range, false);
    }
  }
}

// A value in a temporary, which nothing else changes.
Operand Lowerer::LoadedOnce(const Operand& value, SourceRange range) {
  const bool loaded =
      value.IsVariable() &&
      program_.variables[static_cast<size_t>(value.variable)].role == Variable::Role::kTemporary;
  if (value.IsConstant() || loaded) return value;
  const Operand temporary = NewTemporary(value.type, range);
  EmitCopy(temporary, value, range);
  return temporary;
}

// A copy of a structure.
ArrayPlace Lowerer::CopyOf(const ArrayPlace& structure, SourceRange range) {
  const Type& type = structure.element;
  ArrayPlace copy = StructureAt(
      NewVariable(Variable::Role::kLocal, fmt::format("{}copy", frame_->prefix), type, {}, range),
      type);
  CopyStructure(copy, structure, range);
  return copy;
}

// What holds the result of a call; of a structure, its first variable.
Operand Lowerer::NewResult(const Expression& call, const FunctionInfo& info) {
  const Type& type = info.type;
  if (type.own == nullptr) return NewTemporary(DataTypeOf(type.basic), call.range);
  const bool numbers =
      std::none_of(type.own->leaves.begin(), type.own->leaves.end(),
                   [](const Leaf& leaf) { return leaf.is_array || leaf.card != nullptr; });
  if (!numbers) {
    return VariableOperand(VariableOf(&call, Variable::Role::kLocal,
                                      fmt::format("{}_result", info.syntax->name), type, {},
                                      call.range));
  }
  const int first = static_cast<int>(program_.variables.size());
  for (const Leaf& leaf : type.own->leaves) {
    NewTemporary(DataTypeOf(leaf.type.basic), call.range);
  }
  return VariableOperand(first);
}

Value Lowerer::LowerOwnCall(const Expression& call, FunctionInfo& info) {
  const BasicType type = info.type.basic;
  Value result = {Operand(), type, type};
  if (++inlined_ > vm::kInstructionMax) stopped_ = true;
  if (stopped_) return result;
  if (!IsComplete(info.type, info.syntax->name, info.syntax->name_range)) return {};
  Scope scope;
  if (!BindArguments(call, info, scope)) return {};
  if (CanShare(info, scope)) return LowerSharedCall(call, info, std::move(scope));
  if (type != BasicType::kVoid) result.operand = NewResult(call, info);
  const int end = NewLabel(info.syntax->name, call.range, "end");
  const size_t before = out_->code.size();
  LowerBodyOf(call, info, std::move(scope), {frame_->body, end, result.operand});
  ++info.copies;
  info.copied = std::max(info.copied, out_->code.size() - before);
  return result;
}

// The statements of a function whose parameters have their values.
void Lowerer::LowerBodyOf(const Expression& call, FunctionInfo& info, Scope scope,
                          const BodyEnd& end) {
  Frame frame;
  frame.info = &info;
  frame.scope_base = scopes_.size();
  frame.prefix = fmt::format("{}_", info.syntax->name);
  frame.body = end.body;
  frame.group = info.group != 0 ? info.group : frame_->group;
  frame.result = end.result;
  frame.return_label = end.label;
  Frame* const outer = frame_;
  const int statement = statement_;
  frame_ = &frame;
  OpenBlock(info.syntax, std::move(scope));
  DefineLabels(frame);
  BeginBody();
  LowerBody(info.syntax->body);
  CloseBlock();
  frame_ = outer;
  statement_ = statement;
  EmitLabel(frame.return_label, call.range);
}

}  // namespace oncard::compiler::lowering
