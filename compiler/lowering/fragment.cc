#include "compiler/lowering/fragment.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <unordered_set>

#include "compiler/lowering/lowerer.h"
#include "compiler/lowering/speller.h"
#include "compiler/tree_walk.h"
#include "vm/arithmetic.h"

namespace oncard::compiler::lowering {
namespace {

bool IsLogicalOperator(const Expression& expression) {
  return expression.kind == Expression::Kind::kBinary &&
         (expression.op == "&&" || expression.op == "||");
}

// The `return` that is all that an `if` decides about, or nullptr.
const Statement* LeaveOf(const Statement& statement) {
  if (statement.kind != Statement::Kind::kIf || statement.else_body != nullptr) return nullptr;
  const Statement* body = statement.body.get();
  while (body->kind == Statement::Kind::kBlock && body->items.size() == 1) {
    body = body->items[0].get();
  }
  return body->kind == Statement::Kind::kReturn ? body : nullptr;
}

class FragmentLowerer : public Lowerer {
 public:
  FragmentLowerer(const FragmentContext& context, const MacroUses& no_macros, Reporter& reporter);

  void AddStatement(const Statement& statement);
  void AddInitialValue(const Declarator& declarator);
  std::optional<Fragment> Take();

 private:
  // A jump or a label in a body that stays in the source.
  struct Edit {
    SourceRange range;
    int label;
    bool defines;  ///< it is the label
  };

  void LowerDeclaration(const Statement& statement) override;
  void LowerInner(const Statement& body) override;
  std::optional<int> JumpTarget(const Statement& statement) override;
  BasicType MemberType(const gtcalls::Member& member) const override;
  std::optional<BasicType> CastType(const Expression& expression) override;
  std::optional<TypedConstant> Evaluate(const Expression& expression) override;
  std::optional<int64_t> EvaluateInteger(const Expression& expression) override;
  void KeepSpelling(const Expression& expression, Operand& constant) override;
  std::optional<Operand> LowerIndex(const Expression& index) override;
  void AssignBoth(const Place& place, const Expression& expression) override;
  Value LowerAssignment(const Expression& expression, bool value_used) override;
  int NewLabel(std::string_view construct, SourceRange keyword, std::string_view part) override;

  void DefineNames(const Statement& statement);
  void DefineNames(const Expression& whole);
  void DefineName(std::string_view name);
  std::optional<Literal> MacroValue(std::string_view name) const;
  bool IsConstant(const Expression& expression) const;
  bool IsPlainOperand(const Expression& expression);
  bool IsSafe(const Expression& expression);
  Value ComputeLogical(const Expression& expression);
  Value Truth(const Expression& expression);
  void FindJumps(const Statement& statement, Targets targets, bool in_switch);
  void NameTemporaries(Fragment& fragment);
  std::vector<char> UsedLabels() const;

  const FragmentContext& context_;
  FunctionInfo info_;
  Frame own_frame_;
  LoweredFunction function_;
  const Statement* whole_ = nullptr;  // that is replaced
  bool failed_ = false;
  std::map<int, const Statement*> bodies_by_label_;  // where each stands
  std::map<int, std::string> leaves_;                // jumps that are written as in the source
  std::vector<Edit> edits_;
};

FragmentLowerer::FragmentLowerer(const FragmentContext& context, const MacroUses& no_macros,
                                 Reporter& reporter)
    : Lowerer(context.options, context.files, no_macros, reporter, {.optimize = false}),
      context_(context) {
  info_.syntax = &context.function;
  info_.type.basic = context.return_type == vm::DataType::kDouble ? BasicType::kDouble
                     : context.return_type == vm::DataType::kVoid ? BasicType::kVoid
                                                                  : BasicType::kInt;
  scopes_.emplace_back();
  own_frame_.info = &info_;
  own_frame_.scope_base = scopes_.size();
  frame_ = &own_frame_;
  out_ = &function_;
}

std::optional<Literal> FragmentLowerer::MacroValue(std::string_view name) const {
  const Entity* entity = context_.lookup(name);
  if (entity == nullptr) return TruthValue(name);
  return entity->kind == Entity::Kind::kMacro ? std::optional(entity->value) : std::nullopt;
}

// The variables and macros that are used. What else a name can mean has no place in an expression
// of the card.
void FragmentLowerer::DefineName(std::string_view name) {
  const Entity* entity = context_.lookup(name);
  if (entity == nullptr || scopes_[0].contains(name)) return;
  Symbol symbol;
  symbol.range = entity->range;
  symbol.offset = IntOperand(0);
  if (entity->kind == Entity::Kind::kMacro) {
    symbol.kind = Symbol::Kind::kConstant;
    symbol.constant.type =
        entity->value.kind == Literal::Kind::kFixed ? BasicType::kDouble : BasicType::kInt;
  } else if (entity->kind == Entity::Kind::kVariable && !entity->invalid &&
             entity->dimensions.size() <= 1) {
    Variable variable;
    variable.role =
        entity->storage == vm::Storage::kGlobal ? Variable::Role::kGlobal : Variable::Role::kLocal;
    variable.name = entity->name;
    variable.type = entity->type;
    variable.size = entity->array_size;
    variable.structure = entity->structure;
    symbol.variable = static_cast<int>(program_.variables.size());
    symbol.type.basic =
        entity->type == vm::DataType::kDouble ? BasicType::kDouble : BasicType::kInt;
    if (entity->structure != nullptr) {
      symbol.type.basic = BasicType::kStructure;
      symbol.type.own = CardStructure(*entity->structure);
    }
    for (int leaf = 0; leaf < LeavesOf(symbol.type); ++leaf) {
      variable.member = static_cast<int16_t>(leaf);
      if (symbol.type.own != nullptr) {
        const Type& member = symbol.type.own->members[static_cast<size_t>(leaf)].type;
        variable.type = DataTypeOf(member.basic);
      }
      program_.variables.push_back(variable);
    }
    if (entity->array_size != 0) symbol.dimensions = {entity->array_size};
  } else {
    failed_ = true;
    symbol.invalid = true;
  }
  scopes_[0].emplace(entity->name, std::move(symbol));
}

void FragmentLowerer::DefineNames(const Expression& whole) {
  ForEachExpression(whole, [this](const Expression& expression) {
    switch (expression.kind) {
      case Expression::Kind::kName:
        DefineName(expression.text);
        return;
      case Expression::Kind::kString:
      case Expression::Kind::kError:
        failed_ = true;
        return;
      case Expression::Kind::kCall: {
        const gtcalls::Command* command = options_.catalogue->Find(expression.operands[0]->text);
        failed_ |=
            command != nullptr && (!command->in_motion_program ||
                                   command->parameters.size() != expression.operands.size() - 1);
        return;
      }
      default:
        return;
    }
  });
}

void FragmentLowerer::DefineNames(const Statement& statement) {
  if (statement.initial != nullptr) DefineNames(*statement.initial);
  for (const Declarator& declarator : statement.declarators) DefineName(declarator.name);
  ForEachWholeExpression(statement, [this](const Expression& whole) { DefineNames(whole); });
  if (statement.kind == Statement::Kind::kSwitch) {
    for (const StatementPtr& item : statement.body->items) {
      if (item->kind == Statement::Kind::kCase) DefineNames(*item->value);
    }
  }
  if (const Statement* leave = LeaveOf(statement); leave != nullptr && leave->value != nullptr) {
    DefineNames(*leave->value);
  }
}

void FragmentLowerer::AddStatement(const Statement& statement) {
  whole_ = &statement;
  DefineNames(statement);
  if (!failed_) LowerStatement(statement);
}

void FragmentLowerer::AddInitialValue(const Declarator& declarator) {
  DefineName(declarator.name);
  DefineNames(*declarator.initialiser);
  const Symbol* symbol = Lookup(declarator.name);
  if (symbol == nullptr) failed_ = true;
  if (!failed_) InitialiseLocal(declarator, *symbol);
}

// The declarations of a `for` stand at the top of the function.
void FragmentLowerer::LowerDeclaration(const Statement& statement) {
  for (const Declarator& declarator : statement.declarators) {
    if (declarator.initialiser != nullptr) AddInitialValue(declarator);
  }
}

// A label stands for the body, so that nothing is assumed about what it does.
void FragmentLowerer::LowerInner(const Statement& body) {
  if (&body == LeaveOf(*whole_)) {
    LowerStatement(body);
    return;
  }
  const int label = NewLabel({}, body.range, {});
  bodies_by_label_.emplace(label, &body);
  EmitLabel(label, body.range);
  FindJumps(body, own_frame_.targets.empty() ? Targets() : own_frame_.targets.back(), true);
}

// What leads to labels of this fragment. Loops and switches in the body have targets of their own.
void FragmentLowerer::FindJumps(const Statement& statement, Targets targets, bool in_switch) {
  switch (statement.kind) {
    case Statement::Kind::kWhile:
    case Statement::Kind::kDo:
    case Statement::Kind::kFor:
      return;
    case Statement::Kind::kSwitch:
      targets.break_label = -1;
      in_switch = false;
      break;
    case Statement::Kind::kBreak:
    case Statement::Kind::kContinue: {
      const int label =
          statement.kind == Statement::Kind::kBreak ? targets.break_label : targets.continue_label;
      if (label >= 0) edits_.push_back({statement.range, label, false});
      return;
    }
    case Statement::Kind::kCase:
    case Statement::Kind::kDefault: {
      if (!in_switch || own_frame_.cases.empty()) return;
      const auto found = own_frame_.cases.back().find(&statement);
      if (found == own_frame_.cases.back().end()) return;
      edits_.push_back({statement.range, found->second, true});
      return;
    }
    default:
      break;
  }
  for (const Statement* below : {statement.body.get(), statement.else_body.get()}) {
    if (below != nullptr) FindJumps(*below, targets, in_switch);
  }
  for (const StatementPtr& item : statement.items) FindJumps(*item, targets, in_switch);
}

// `if (c) goto l;` and `if (c) return x;` are statements of the card.
std::optional<int> FragmentLowerer::JumpTarget(const Statement& statement) {
  const bool returns =
      statement.kind == Statement::Kind::kReturn &&
      (statement.value == nullptr ||
       (IsPlainOperand(*statement.value) && TypeOf(*statement.value) == info_.type.basic));
  if (!returns && statement.kind != Statement::Kind::kGoto) {
    return statement.kind == Statement::Kind::kBlock ? Lowerer::JumpTarget(statement)
                                                     : std::nullopt;
  }
  std::string text(Source(statement.range));
  if (!text.ends_with(';')) text += ';';
  const int label = NewLabel({}, statement.range, {});
  leaves_.emplace(label, std::move(text));
  return label;
}

BasicType FragmentLowerer::MemberType(const gtcalls::Member& member) const {
  return gtcalls::ProgramType(member.type) == vm::DataType::kDouble ? BasicType::kDouble
                                                                    : BasicType::kInt;
}

std::optional<BasicType> FragmentLowerer::CastType(const Expression& expression) {
  if (expression.text == "double") return BasicType::kDouble;
  const bool is_int =
      expression.text == "int" || expression.text == "long" || expression.text == "short";
  return is_int ? std::optional(BasicType::kInt) : std::nullopt;
}

// A number or a macro, which may have a minus.
bool FragmentLowerer::IsConstant(const Expression& expression) const {
  const Expression* inner = &expression;
  const bool minus = inner->kind == Expression::Kind::kUnary && inner->op == "-";
  if (minus) inner = inner->operands[0].get();
  if (inner->kind == Expression::Kind::kLiteral) return true;
  const Symbol* symbol = inner->kind == Expression::Kind::kName ? Lookup(inner->text) : nullptr;
  return symbol != nullptr && symbol->kind == Symbol::Kind::kConstant;
}

std::optional<TypedConstant> FragmentLowerer::Evaluate(const Expression& expression) {
  const Expression& inner = WithoutParens(expression);
  if (!IsConstant(inner)) {
    // The card has no minus of its own.
    const bool minus = inner.kind == Expression::Kind::kUnary && inner.op == "-";
    return minus ? Lowerer::Evaluate(inner) : std::nullopt;
  }
  TypedConstant constant;
  // A number that does not fit its type is reported where it is; here only its spelling matters.
  constant.value =
      Fold(inner, [this](std::string_view name) { return MacroValue(name); }).value_or(Constant());
  constant.type = constant.value.is_double ? BasicType::kDouble : BasicType::kInt;
  return constant;
}

std::optional<int64_t> FragmentLowerer::EvaluateInteger(const Expression& expression) {
  const std::optional<Constant> value =
      Fold(expression, [this](std::string_view name) { return MacroValue(name); });
  return value && !value->is_double ? std::optional(value->integer) : std::nullopt;
}

void FragmentLowerer::KeepSpelling(const Expression& expression, Operand& constant) {
  const Expression& inner = WithoutParens(expression);
  if (!IsConstant(inner)) return;
  // An int is written where a double is expected, but not the other way round.
  if (constant.type == vm::DataType::kInt && Evaluate(inner)->type == BasicType::kDouble) return;
  constant.name = static_cast<int>(program_.constants.size());
  program_.constants.push_back({std::string(Source(inner.range)), constant, inner.range});
}

// True if the text of an expression can be used as an operand without changes.
bool FragmentLowerer::IsPlainOperand(const Expression& expression) {
  if (IsConstant(expression)) return true;
  if (expression.kind == Expression::Kind::kIndex) {
    const Expression& index = *expression.operands[1];
    return IsConstant(index) ||
           (index.kind == Expression::Kind::kName && TypeOf(index) == BasicType::kInt);
  }
  return expression.kind == Expression::Kind::kName || expression.kind == Expression::Kind::kMember;
}

// True if an expression may be computed even where C would not evaluate it: it changes nothing and
// cannot stop the thread.
bool FragmentLowerer::IsSafe(const Expression& expression) {
  using Kind = Expression::Kind;
  if (IsConstant(expression)) return true;
  if (HasEffects(expression)) return false;
  switch (expression.kind) {
    case Kind::kName:
    case Kind::kMember:
      return true;
    case Kind::kIndex:
      return IsConstant(*expression.operands[1]);
    case Kind::kBinary: {
      const vm::OperatorInfo& info = *vm::FindBinaryOperator(expression.op);
      if (vm::Divides(static_cast<vm::BinaryOperator>(info.number))) {
        const std::optional<TypedConstant> divisor = Evaluate(*expression.operands[1]);
        if (!divisor || divisor->value.AsDouble() == 0) return false;
      }
      break;
    }
    case Kind::kUnary:
    case Kind::kParen:
    case Kind::kCast:
      break;
    case Kind::kCall:  // abs, fabs
      return std::all_of(expression.operands.begin() + 1, expression.operands.end(),
                         [this](const ExpressionPtr& argument) { return IsSafe(*argument); });
    default:
      return false;
  }
  return std::all_of(expression.operands.begin(), expression.operands.end(),
                     [this](const ExpressionPtr& operand) { return IsSafe(*operand); });
}

// An int that is 0 exactly when the expression is.
Value FragmentLowerer::Truth(const Expression& expression) {
  const Value value = LowerValue(expression);
  if (!RequireNumber(value, expression) || value.type != BasicType::kDouble) return value;
  return Compute(vm::BinaryOperator::kNotEqual, value.operand,
                 ConstantOperand(vm::DataType::kDouble, 0), BasicType::kInt, expression.range);
}

Value FragmentLowerer::ComputeLogical(const Expression& expression) {
  const Value a = Truth(*expression.operands[0]);
  const Value b = Truth(*expression.operands[1]);
  if (IsVoid(a) || IsVoid(b)) return {};
  const auto op = static_cast<vm::BinaryOperator>(vm::FindBinaryOperator(expression.op)->number);
  return Compute(op, a.operand, b.operand, BasicType::kInt, expression.range);
}

// C has no double as an index. Where an int is wanted elsewhere, C converts it.
std::optional<Operand> FragmentLowerer::LowerIndex(const Expression& index) {
  const Value value = LowerValue(index);
  if (!RequireNumber(value, index)) return std::nullopt;
  return Convert(value, BasicType::kInt, index.range).operand;
}

void FragmentLowerer::AssignBoth(const Place& place, const Expression& expression) {
  const bool negated = expression.kind == Expression::Kind::kUnary;
  const Expression& inner = negated ? WithoutParens(*expression.operands[0]) : expression;
  if (!IsLogicalOperator(inner) || !IsSafe(*inner.operands[1])) {
    Lowerer::AssignBoth(place, expression);
    return;
  }
  Value value = ComputeLogical(inner);
  if (IsVoid(value)) return;
  if (negated) {
    value = Compute(vm::UnaryOperator::kNot, value.operand, BasicType::kInt, expression.range);
  }
  Store(place, value, expression.range, false);
}

// `rtn = GT_Stop(1, 0)`: a program of the card cannot see return codes.
Value FragmentLowerer::LowerAssignment(const Expression& expression, bool value_used) {
  const Expression& value = WithoutParens(*expression.operands[1]);
  if (!value_used && value.kind == Expression::Kind::kCall &&
      options_.catalogue->Find(value.operands[0]->text) != nullptr) {
    return LowerCall(value);
  }
  return Lowerer::LowerAssignment(expression, value_used);
}

// Without the line, which the edit itself changes.
int FragmentLowerer::NewLabel(std::string_view construct, SourceRange /*keyword*/,
                              std::string_view part) {
  const bool skips = (construct == "and" || construct == "or") && part == "end";
  function_.labels.push_back(fmt::format("lbl_{}", skips ? "skip" : part.empty() ? "loop" : part));
  return static_cast<int>(function_.labels.size()) - 1;
}

// The labels to which something jumps, or that are needed in a body.
std::vector<char> FragmentLowerer::UsedLabels() const {
  std::vector<char> used(function_.labels.size());
  for (const Instruction& instruction : function_.code) {
    if (instruction.kind != Instruction::Kind::kLabel && instruction.label >= 0) {
      used[static_cast<size_t>(instruction.label)] = 1;
    }
  }
  for (const Edit& edit : edits_) used[static_cast<size_t>(edit.label)] = 1;
  return used;
}

// A condition is read by the statement after the one that computes it, so that one variable is
// enough for all of them. Every other value has a variable of its own.
void FragmentLowerer::NameTemporaries(Fragment& fragment) {
  const auto temporary = [this](const Operand& operand) -> Variable* {
    if (!operand.IsVariable()) return nullptr;
    Variable& variable = program_.variables[static_cast<size_t>(operand.variable)];
    return variable.role == Variable::Role::kTemporary ? &variable : nullptr;
  };
  const auto declare = [this, &fragment](std::string_view base, Variable& variable) {
    variable.name = context_.fresh.Make(base);
    fragment.declarations.push_back(fmt::format("{} {};", SpellType(variable), variable.name));
  };
  std::unordered_set<const Variable*> conditions;
  for (auto at = function_.code.rbegin(); at != function_.code.rend(); ++at) {
    if (at->kind == Instruction::Kind::kIf) {
      if (const Variable* variable = temporary(at->a)) conditions.insert(variable);
    } else if (at->kind == Instruction::Kind::kUnary && at->unary == vm::UnaryOperator::kNot &&
               conditions.contains(temporary(at->target))) {
      const Variable* variable = temporary(at->a);
      if (variable != nullptr && variable->type == vm::DataType::kInt) conditions.insert(variable);
    }
  }
  const Variable* condition = nullptr;
  for (const Instruction& instruction : function_.code) {
    Variable* variable = temporary(instruction.target);
    if (variable == nullptr || !variable->name.empty()) continue;
    if (!conditions.contains(variable)) {
      declare("tmp", *variable);
    } else if (condition == nullptr) {
      declare("cc", *variable);
      condition = variable;
    } else {
      variable->name = condition->name;
    }
  }
}

std::optional<Fragment> FragmentLowerer::Take() {
  if (failed_ || stopped_ || reporter_.HasErrors()) return std::nullopt;
  Fragment fragment;
  NameTemporaries(fragment);
  const std::vector<char> used = UsedLabels();
  for (size_t i = 0; i < used.size(); ++i) {
    const bool own = !leaves_.contains(static_cast<int>(i));
    if (used[i] != 0 && own) function_.labels[i] = context_.fresh.Make(function_.labels[i]);
  }
  Speller speller(program_);
  for (size_t i = 0; i < program_.constants.size(); ++i) speller.UseName(static_cast<int>(i));
  fragment.parts.emplace_back();
  for (const Instruction& instruction : function_.code) {
    std::vector<std::string>& lines = fragment.parts.back().lines;
    if (instruction.kind == Instruction::Kind::kLabel) {
      const auto body = bodies_by_label_.find(instruction.label);
      if (body != bodies_by_label_.end()) {
        fragment.parts.back().body = body->second;
        fragment.parts.emplace_back();
        continue;
      }
      if (used[static_cast<size_t>(instruction.label)] == 0) continue;
    }
    const auto leave = leaves_.find(instruction.label);
    if (leave == leaves_.end()) {
      lines.push_back(speller.Spell(instruction, function_));
    } else if (instruction.kind == Instruction::Kind::kIf) {
      lines.push_back(fmt::format("if ({}) {}", speller.Spell(instruction.a), leave->second));
    } else {
      lines.push_back(leave->second);
    }
  }
  for (const Edit& edit : edits_) {
    const std::string& name = function_.labels[static_cast<size_t>(edit.label)];
    fragment.edits.push_back(
        {edit.range, edit.defines ? name + ":" : fmt::format("goto {};", name)});
  }
  return fragment;
}

}  // namespace

std::optional<Fragment> LowerFragment(const FragmentContext& context, const Statement& statement) {
  Reporter reporter;
  const MacroUses no_macros;
  FragmentLowerer lowerer(context, no_macros, reporter);
  lowerer.AddStatement(statement);
  return lowerer.Take();
}

std::optional<Fragment> LowerInitialValues(const FragmentContext& context,
                                           const std::vector<const Declarator*>& declarators) {
  Reporter reporter;
  const MacroUses no_macros;
  FragmentLowerer lowerer(context, no_macros, reporter);
  for (const Declarator* declarator : declarators) lowerer.AddInitialValue(*declarator);
  return lowerer.Take();
}

}  // namespace oncard::compiler::lowering
