// Expressions: splits them into operations that each fit one statement.
#include "compiler/rewriter.h"

#include <algorithm>

#include "compiler/operators.h"
#include "compiler/tree_walk.h"
#include "vm/arithmetic.h"

namespace oncard::compiler {
namespace {

using vm::DataType;

// Up to this number of elements are set to 0 by separate statements; more need a loop.
constexpr size_t kZeroesInLine = 8;

const Expression& Unwrapped(const Expression& expression) {
  const Expression* inner = &expression;
  while (inner->kind == Expression::Kind::kParen) inner = inner->operands[0].get();
  return *inner;
}

bool IsLogical(const Expression& expression) {
  return expression.kind == Expression::Kind::kBinary &&
         vm::IsLogical(*vm::FindBinaryOperator(expression.op));
}

// The comparison that an expression is, or of what it is not; nullptr if it is another expression.
const vm::OperatorInfo* Comparison(const Expression& expression, bool negate) {
  if (expression.kind != Expression::Kind::kBinary) return nullptr;
  const vm::OperatorInfo* info = vm::FindBinaryOperator(expression.op);
  if (!vm::IsComparison(*info)) return nullptr;
  return negate ? OppositeOf(*info) : info;
}

}  // namespace

Rewriter::Value Rewriter::Fail() {
  ok_ = false;
  return {};
}

void Rewriter::Refuse(Message reason) {
  if (ok_) AddNote(diagnostic_, std::move(reason));
  ok_ = false;
}

void Rewriter::Refuse(SourceRange place, Message reason) {
  if (ok_) AddNote(diagnostic_, place, std::move(reason));
  ok_ = false;
}

std::string Rewriter::Temporary(std::string_view base, DataType type) {
  std::string name = checker_.fresh_.Make(base);
  declarations_.push_back(
      fmt::format("{} {};", type == DataType::kDouble ? "double" : "int", name));
  return name;
}

std::string Rewriter::ConditionVariable() {
  if (condition_variable_.empty()) condition_variable_ = Temporary("cc", DataType::kInt);
  return condition_variable_;
}

std::string Rewriter::Label(std::string_view base) { return checker_.fresh_.Make(base); }

std::string Rewriter::OutputVariable(std::string_view base, DataType type) {
  return Temporary(base, type);
}

Rewriter::Value Rewriter::Operand(Value value) {
  if (value.leaf) return value;
  const std::string name = Temporary("tmp", value.type);
  Emit(fmt::format("{} = {};", name, value.text));
  return {name, value.type, true, false, true};
}

Rewriter::Value Rewriter::Converted(Value value, DataType type) {
  if (value.type == type) return value;
  // With a double as the other operand, a literal int is used as a double.
  if (value.literal && type == DataType::kDouble) {
    value.type = type;
    return value;
  }
  const Value operand = Operand(std::move(value));
  return {fmt::format("({}) {}", type == DataType::kDouble ? "double" : "int", operand.text), type,
          false};
}

void Rewriter::Assign(const Value& target, Value value) {
  value = Converted(std::move(value), target.type);
  if (value.leaf && value.text == target.text) return;
  Emit(fmt::format("{} = {};", target.text, value.text));
}

// The text of an index in a permitted form: a literal or an int variable.
std::string Rewriter::IndexText(const Expression& expression) {
  Value index = Lower(expression);
  if (!ok_) return {};
  index = Converted(std::move(index), DataType::kInt);
  if (index.leaf && (index.literal || index.variable)) return index.text;
  if (!index.leaf) return Operand(std::move(index)).text;
  std::string name = Temporary("tmp", DataType::kInt);
  Emit(fmt::format("{} = {};", name, index.text));
  return name;
}

Rewriter::Value Rewriter::LeafIndex(const Expression& expression) {
  const Expression& base = *expression.operands[0];
  if (base.kind != Expression::Kind::kName) return Fail();
  const Entity* array = checker_.Lookup(base.text);
  if (array == nullptr || array->invalid || array->array_size == 0 ||
      array->dimensions.size() > 1) {
    return Fail();
  }
  const std::string index = IndexText(*expression.operands[1]);
  return {fmt::format("{}[{}]", base.text, index), array->type, true};
}

Rewriter::Value Rewriter::Leaf(const Expression& expression) {
  if (const std::optional<Literal> constant = checker_.ConstantOf(expression)) {
    return {std::string(Source(expression.range)),
            constant->kind == Literal::Kind::kFixed ? DataType::kDouble : DataType::kInt, true,
            true};
  }
  if (expression.kind == Expression::Kind::kIndex) return LeafIndex(expression);
  const Expression& name =
      expression.kind == Expression::Kind::kMember ? *expression.operands[0] : expression;
  if (name.kind != Expression::Kind::kName) return Fail();
  const Entity* entity = checker_.Lookup(name.text);
  if (entity == nullptr || entity->invalid || entity->kind != Entity::Kind::kVariable ||
      entity->array_size != 0) {
    return Fail();
  }
  if (expression.kind == Expression::Kind::kName) {
    if (entity->structure != nullptr) return Fail();
    return {std::string(expression.text), entity->type, true, false, true};
  }
  if (entity->structure == nullptr) return Fail();
  for (const gtcalls::Member& member : entity->structure->members) {
    if (member.name == expression.text) {
      return {fmt::format("{}.{}", name.text, member.name), gtcalls::ProgramType(member.type),
              true};
    }
  }
  return Fail();
}

// True if the text of an expression can be used as an operand without changes.
bool Rewriter::IsPlainOperand(const Expression& expression) const {
  if (checker_.ConstantOf(expression)) return true;
  if (expression.kind == Expression::Kind::kIndex) {
    const Expression& index = *expression.operands[1];
    return checker_.ConstantOf(index) ||
           (index.kind == Expression::Kind::kName && TypeOf(index) == DataType::kInt);
  }
  return expression.kind == Expression::Kind::kName || expression.kind == Expression::Kind::kMember;
}

Rewriter::Value Rewriter::Target(const Expression& expression) {
  const Expression& inner = Unwrapped(expression);
  if (checker_.ConstantOf(inner) || !Checker::IsLeaf(inner)) return Fail();
  return Leaf(inner);
}

Rewriter::Value Rewriter::LowerBinary(Value left, std::string_view op, Value right) {
  const vm::OperatorInfo& info = *vm::FindBinaryOperator(op);
  if (vm::IsLogical(info)) {
    for (Value* side : {&left, &right}) {
      if (side->type != DataType::kDouble) continue;
      *side = {fmt::format("{} != 0.0", side->text), DataType::kInt, false};
      *side = Operand(std::move(*side));
    }
  } else if (left.type == DataType::kDouble || right.type == DataType::kDouble) {
    if (!vm::Accepts(info, DataType::kDouble)) return Fail();
    if (left.type != right.type) {
      left = Operand(Converted(std::move(left), DataType::kDouble));
      right = Operand(Converted(std::move(right), DataType::kDouble));
    }
  }
  const DataType type = vm::ResultOf(info, left.type);
  return {fmt::format("{} {} {}", left.text, op, right.text), type, false};
}

// True if an expression may be computed even where C would not evaluate it: it changes nothing and
// cannot stop the thread.
bool Rewriter::IsSafe(const Expression& expression) const {
  if (checker_.ConstantOf(expression)) return true;
  switch (expression.kind) {
    case Expression::Kind::kName:
    case Expression::Kind::kMember:
      return true;
    case Expression::Kind::kIndex:
      return checker_.ConstantOf(*expression.operands[1]).has_value();
    case Expression::Kind::kBinary:
      if (vm::Divides(
              static_cast<vm::BinaryOperator>(vm::FindBinaryOperator(expression.op)->number))) {
        const std::optional<Literal> divisor = checker_.ConstantOf(*expression.operands[1]);
        if (!divisor || divisor->magnitude == 0) return false;
      }
      break;
    case Expression::Kind::kUnary:
    case Expression::Kind::kParen:
    case Expression::Kind::kCast:
      break;
    case Expression::Kind::kCall:  // abs, fabs
      return !HasEffects(expression) &&
             std::all_of(expression.operands.begin() + 1, expression.operands.end(),
                         [this](const ExpressionPtr& argument) { return IsSafe(*argument); });
    default:
      return false;
  }
  return !HasEffects(expression) &&
         std::all_of(expression.operands.begin(), expression.operands.end(),
                     [this](const ExpressionPtr& operand) { return IsSafe(*operand); });
}

// The value of `a && b` or `a || b`. The second operand is computed only if the first does not
// decide the result, unless computing it has no effect.
Rewriter::Value Rewriter::LowerLogical(const Expression& expression) {
  if (IsSafe(*expression.operands[1])) {
    Value left = Operand(Lower(*expression.operands[0]));
    Value right = Operand(Lower(*expression.operands[1]));
    if (!ok_) return {};
    return LowerBinary(std::move(left), expression.op, std::move(right));
  }
  Value result = {Temporary("tmp", DataType::kInt), DataType::kInt, true, false, true};
  const std::string end = Label("lbl_end");
  Emit(fmt::format("{} = 0;", result.text));
  JumpIf(expression, true, end);
  Emit(fmt::format("{} = 1;", result.text));
  EmitLabel(end);
  return result;
}

Rewriter::Value Rewriter::LowerStep(const Expression& expression, bool value_used) {
  const Value target = Target(*expression.operands[0]);
  if (!ok_) return {};
  Value result = target;
  if (value_used && expression.kind == Expression::Kind::kPostfix) {
    result = {Temporary("tmp", target.type), target.type, true, false, true};
    Emit(fmt::format("{} = {};", result.text, target.text));
  }
  Emit(fmt::format("{} = {} {} 1;", target.text, target.text, expression.op.substr(1)));
  return result;
}

Rewriter::Value Rewriter::LowerAssignment(const Expression& expression) {
  Value target = Target(*expression.operands[0]);
  if (!ok_) return {};
  Value value = Lower(*expression.operands[1]);
  if (!ok_) return {};
  if (expression.kind == Expression::Kind::kCompound) {
    const std::string_view op = expression.op.substr(0, expression.op.size() - 1);
    value = LowerBinary(target, op, Operand(std::move(value)));
    if (!ok_) return {};
  }
  Assign(target, std::move(value));
  return target;
}

Rewriter::Value Rewriter::LowerUnary(const Expression& expression) {
  if (expression.op == "++" || expression.op == "--") return LowerStep(expression, true);
  Value inner = Lower(*expression.operands[0]);
  if (!ok_) return {};
  if (expression.op == "+") return inner;
  inner = Operand(std::move(inner));
  if (expression.op == "-") {
    if (inner.literal && inner.text.front() != '-') {
      inner.text.insert(0, 1, '-');
      return inner;
    }
    return {fmt::format("0 - {}", inner.text), inner.type, false};
  }
  if (expression.op == "!" && inner.type == DataType::kDouble) {
    return {fmt::format("{} == 0.0", inner.text), DataType::kInt, false};
  }
  const vm::OperatorInfo* info = vm::FindUnaryOperator(expression.op);
  if (info == nullptr || !vm::Accepts(*info, inner.type)) return Fail();
  return {fmt::format("{}{}", expression.op, inner.text), vm::ResultOf(*info, inner.type), false};
}

// The type of an expression, determined before any part of it is rewritten.
DataType Rewriter::TypeOf(const Expression& expression) const {
  if (const std::optional<Literal> constant = checker_.ConstantOf(expression)) {
    return constant->kind == Literal::Kind::kFixed ? DataType::kDouble : DataType::kInt;
  }
  const auto either = [this](const Expression& a, const Expression& b) {
    return TypeOf(a) == DataType::kDouble ? DataType::kDouble : TypeOf(b);
  };
  const auto entity_type = [this](const Expression& name) {
    const Entity* entity = checker_.Lookup(name.text);
    return entity != nullptr ? entity->type : DataType::kInt;
  };
  switch (expression.kind) {
    case Expression::Kind::kName:
      return entity_type(expression);
    case Expression::Kind::kIndex: {
      const Expression* base = &expression;
      while (base->kind == Expression::Kind::kIndex) base = base->operands[0].get();
      return entity_type(*base);
    }
    case Expression::Kind::kMember: {
      const Entity* entity = checker_.Lookup(expression.operands[0]->text);
      if (entity == nullptr || entity->structure == nullptr) return DataType::kInt;
      for (const gtcalls::Member& member : entity->structure->members) {
        if (member.name == expression.text) return gtcalls::ProgramType(member.type);
      }
      return DataType::kInt;
    }
    case Expression::Kind::kCast:
      return expression.text == "double" ? DataType::kDouble : DataType::kInt;
    case Expression::Kind::kCall:
      return expression.operands[0]->text == "fabs" ? DataType::kDouble : DataType::kInt;
    case Expression::Kind::kUnary:
      if (const vm::OperatorInfo* info = vm::FindUnaryOperator(expression.op)) {
        return vm::ResultOf(*info, TypeOf(*expression.operands[0]));
      }
      return TypeOf(*expression.operands[0]);
    case Expression::Kind::kBinary:
      return vm::ResultOf(*vm::FindBinaryOperator(expression.op),
                          either(*expression.operands[0], *expression.operands[1]));
    case Expression::Kind::kConditional:
      return either(*expression.operands[1], *expression.operands[2]);
    case Expression::Kind::kComma:
      return TypeOf(*expression.operands[1]);
    case Expression::Kind::kParen:
    case Expression::Kind::kPostfix:
    case Expression::Kind::kAssign:
    case Expression::Kind::kCompound:
      return TypeOf(*expression.operands[0]);
    default:
      return DataType::kInt;
  }
}

Rewriter::Value Rewriter::LowerConditional(const Expression& expression) {
  const std::string otherwise = Label("lbl_else");
  const std::string end = Label("lbl_end");
  JumpIf(*expression.operands[0], true, otherwise);
  if (!ok_) return {};
  const DataType type = TypeOf(expression);
  Value result = {Temporary("tmp", type), type, true, false, true};
  Assign(result, Lower(*expression.operands[1]));
  Emit(fmt::format("goto {};", end));
  EmitLabel(otherwise);
  Assign(result, Lower(*expression.operands[2]));
  EmitLabel(end);
  return result;
}

Rewriter::Value Rewriter::LowerCall(const Expression& expression) {
  const Expression& callee = *expression.operands[0];
  if (callee.kind != Expression::Kind::kName || checker_.Lookup(callee.text) != nullptr ||
      (callee.text != "abs" && callee.text != "fabs") || expression.operands.size() != 2) {
    return Fail();
  }
  const DataType type = callee.text == "fabs" ? DataType::kDouble : DataType::kInt;
  Value operand = Lower(*expression.operands[1]);
  if (!ok_) return {};
  operand = Operand(Converted(Operand(std::move(operand)), type));
  return {fmt::format("{}({})", callee.text, operand.text), type, false};
}

Rewriter::Value Rewriter::Lower(const Expression& expression) {
  if (!ok_) return {};
  if (Checker::IsLeaf(expression) || checker_.ConstantOf(expression)) return Leaf(expression);
  switch (expression.kind) {
    case Expression::Kind::kParen:
      return Lower(*expression.operands[0]);
    case Expression::Kind::kUnary:
      return LowerUnary(expression);
    case Expression::Kind::kPostfix:
      return LowerStep(expression, true);
    case Expression::Kind::kAssign:
    case Expression::Kind::kCompound:
      return LowerAssignment(expression);
    case Expression::Kind::kConditional:
      return LowerConditional(expression);
    case Expression::Kind::kCall:
      return LowerCall(expression);
    case Expression::Kind::kComma:
      LowerEffect(*expression.operands[0]);
      return Lower(*expression.operands[1]);
    case Expression::Kind::kCast: {
      Value inner = Lower(*expression.operands[0]);
      if (!ok_ || expression.text.empty()) return Fail();
      if (expression.text != "double" && expression.text != "int" && expression.text != "long" &&
          expression.text != "short") {
        return Fail();
      }
      const DataType type = expression.text == "double" ? DataType::kDouble : DataType::kInt;
      if (inner.type == type) return inner;
      inner = Operand(std::move(inner));
      return {fmt::format("({}) {}", expression.text, inner.text), type, false};
    }
    case Expression::Kind::kBinary: {
      if (IsLogical(expression)) return LowerLogical(expression);
      Value left = Operand(Lower(*expression.operands[0]));
      Value right = Operand(Lower(*expression.operands[1]));
      if (!ok_) return {};
      return LowerBinary(std::move(left), expression.op, std::move(right));
    }
    default:
      return Fail();
  }
}

void Rewriter::LowerCommand(const Expression& call) {
  const gtcalls::Command* command = checker_.catalogue_.Find(call.operands[0]->text);
  if (command == nullptr || !command->in_motion_program ||
      command->parameters.size() != call.operands.size() - 1) {
    ok_ = false;
    return;
  }
  std::string text = std::string(command->name) + '(';
  for (size_t i = 0; i < command->parameters.size(); ++i) {
    const gtcalls::Parameter& parameter = command->parameters[i];
    const Expression& argument = *call.operands[i + 1];
    if (i > 0) text += ", ";
    if (argument.kind == Expression::Kind::kUnary && argument.op == "&") {
      const Expression& variable = *argument.operands[0];
      text += '&';
      text += variable.kind == Expression::Kind::kIndex ? LeafIndex(variable).text
                                                        : std::string(Source(variable.range));
      continue;
    }
    Value value = Lower(argument);
    if (!ok_) return;
    text += Operand(Converted(std::move(value), gtcalls::ProgramType(parameter.type))).text;
  }
  Emit(text + ");");
}

// A return code that is never used can be dropped.
void Rewriter::DropResult(const Expression& target) {
  const std::string_view name = BaseName(target);
  const Entity* entity = checker_.Lookup(name);
  if (entity == nullptr || HasEffects(target)) {
    ok_ = false;
    return;
  }
  if (entity->storage == vm::Storage::kGlobal) {
    Refuse(MakeMessage(
        "the host may read the global '{0}'; let it read TThreadSts.error instead, then remove "
        "'{0} ='",
        "主机可能读取全局变量 '{0}'；请改为查看 TThreadSts.error，再去掉 '{0} ='", name));
    return;
  }
  if (const Expression* read = checker_.UsesInFunction(name).first_read) {
    Refuse(read->range,
           MakeMessage("'{0}' is read here, but a motion program cannot see return codes; remove "
                       "this use, the host finds the code in TThreadSts.error",
                       "此处使用了 '{0}'，但运动程序看不到返回值；请去掉此处的使用，主机可在 "
                       "TThreadSts.error 中查看返回值",
                       name));
  }
}

void Rewriter::LowerEffect(const Expression& expression) {
  const Expression& inner = Unwrapped(expression);
  if (!ok_) return;
  switch (inner.kind) {
    case Expression::Kind::kAssign: {
      // `rtn = GT_...`: the return code is available in the thread's status.
      const Expression& value = Unwrapped(*inner.operands[1]);
      if (value.kind == Expression::Kind::kCall &&
          value.operands[0]->kind == Expression::Kind::kName &&
          checker_.catalogue_.Find(value.operands[0]->text) != nullptr) {
        DropResult(*inner.operands[0]);
        LowerCommand(value);
        return;
      }
      LowerAssignment(inner);
      return;
    }
    case Expression::Kind::kCompound:
      LowerAssignment(inner);
      return;
    case Expression::Kind::kComma:
      LowerEffect(*inner.operands[0]);
      LowerEffect(*inner.operands[1]);
      return;
    case Expression::Kind::kCall:
      if (inner.operands[0]->kind == Expression::Kind::kName) {
        LowerCommand(inner);
      } else {
        ok_ = false;
      }
      return;
    case Expression::Kind::kPostfix:
      LowerStep(inner, false);
      return;
    case Expression::Kind::kUnary:
      if (inner.op == "++" || inner.op == "--") {
        LowerStep(inner, false);
        return;
      }
      break;
    default:
      break;
  }
  // The value is not used, but side effects must be kept.
  if (HasEffects(inner)) Lower(inner);
}

// Elements without a value are set to 0 in C each time the declaration is executed.
void Rewriter::InitialiseArray(const std::vector<ExpressionPtr>& values, const Entity& array) {
  if (array.dimensions.size() > 1 || values.size() > array.array_size) {
    ok_ = false;
    return;
  }
  for (size_t i = 0; i < values.size() && ok_; ++i) {
    const Value target = {fmt::format("{}[{}]", array.name, i), array.type, true};
    Value value = Lower(*values[i]);
    if (ok_) Assign(target, std::move(value));
  }
  const size_t rest = array.array_size - values.size();
  if (rest <= kZeroesInLine) {
    for (size_t i = values.size(); i < array.array_size; ++i) {
      Emit(fmt::format("{}[{}] = 0;", array.name, i));
    }
    return;
  }
  const std::string index = Temporary("tmp", DataType::kInt);
  const std::string loop = Label("lbl_loop");
  const std::string condition = ConditionVariable();
  Emit(fmt::format("{} = {};", index, values.size()));
  EmitLabel(loop);
  Emit(fmt::format("{}[{}] = 0;", array.name, index));
  Emit(fmt::format("{0} = {0} + 1;", index));
  Emit(fmt::format("{} = {} < {};", condition, index, array.array_size));
  Emit(fmt::format("if ({}) goto {};", condition, loop));
}

void Rewriter::Initialise(const Declarator& declarator, const Entity& entity) {
  if (entity.structure != nullptr) {
    Refuse(MakeMessage("assign the members of '{0}' one by one in statements",
                       "请用语句逐个给 '{0}' 的成员赋值", entity.name));
    return;
  }
  const bool braces = declarator.initialiser->kind == Expression::Kind::kBraces;
  if (braces != (entity.array_size != 0)) {
    ok_ = false;
    return;
  }
  if (braces) {
    InitialiseArray(declarator.initialiser->operands, entity);
    return;
  }
  Value value = Lower(*declarator.initialiser);
  if (ok_) Assign({std::string(entity.name), entity.type, true, false, true}, std::move(value));
}

Rewriter::Condition Rewriter::LowerCondition(const Expression& expression, bool negate) {
  const Expression& inner = Unwrapped(expression);
  if (inner.kind == Expression::Kind::kUnary && inner.op == "!") {
    return LowerCondition(*inner.operands[0], !negate);
  }
  if (const std::optional<Literal> constant = checker_.ConstantOf(inner)) {
    const bool zero = constant->kind == Literal::Kind::kInteger
                          ? IntValue(*constant).value_or(1) == 0
                          : constant->magnitude == 0;
    return {true, zero == negate, {}};
  }
  Value value;
  if (const vm::OperatorInfo* comparison = Comparison(inner, negate)) {
    Value left = Operand(Lower(*inner.operands[0]));
    Value right = Operand(Lower(*inner.operands[1]));
    if (!ok_) return {};
    value = LowerBinary(std::move(left), comparison->spelling, std::move(right));
    negate = false;
  } else {
    value = Lower(inner);
    if (!ok_) return {};
    if (value.type == DataType::kDouble) {
      const Value operand = Operand(std::move(value));
      value = {fmt::format("{} {} 0.0", operand.text, negate ? "==" : "!="), DataType::kInt, false};
      negate = false;
    }
  }
  if (!ok_) return {};
  if (value.leaf && value.variable && !negate) return {false, false, value.text};
  const std::string variable = ConditionVariable();
  if (negate && value.leaf) {
    Emit(fmt::format("{} = !{};", variable, value.text));
  } else {
    Emit(fmt::format("{} = {};", variable, value.text));
    if (negate) Emit(fmt::format("{0} = !{0};", variable));
  }
  return {false, false, variable};
}

// Jumps if the condition holds or, with `negate`, if it does not.
void Rewriter::JumpIf(const Expression& condition, bool negate, const std::string& label) {
  const Expression& inner = Unwrapped(condition);
  if (!ok_) return;
  if (inner.kind == Expression::Kind::kUnary && inner.op == "!") {
    JumpIf(*inner.operands[0], !negate, label);
    return;
  }
  if (inner.kind == Expression::Kind::kComma) {
    LowerEffect(*inner.operands[0]);
    JumpIf(*inner.operands[1], negate, label);
    return;
  }
  if (IsLogical(inner)) {
    const bool takes_both = (inner.op == "&&") != negate;
    if (!takes_both) {
      JumpIf(*inner.operands[0], negate, label);
      JumpIf(*inner.operands[1], negate, label);
      return;
    }
    const std::string skip = Label("lbl_skip");
    JumpIf(*inner.operands[0], !negate, skip);
    JumpIf(*inner.operands[1], negate, label);
    EmitLabel(skip);
    return;
  }
  const Condition result = LowerCondition(inner, negate);
  if (!ok_) return;
  if (!result.constant) {
    Emit(fmt::format("if ({}) goto {};", result.variable, label));
  } else if (result.truth) {
    Emit(fmt::format("goto {};", label));
  }
}

}  // namespace oncard::compiler
