// The nodes of the syntax tree, as the parser builds them.
#include <fmt/core.h>

#include <algorithm>

#include "compiler/parser_driver.h"

namespace oncard::compiler {
namespace {

// The levels of a node, below which are these.
class LevelsAbove {
 public:
  template <typename Node>
  void Nest(const std::unique_ptr<Node>& below) {
    Add(below, 1);
  }
  /// For the next one in a row, as in a sum.
  template <typename Node>
  void Continue(const std::unique_ptr<Node>& below) {
    Add(below, 0);
  }
  void Nest(const Specifiers& specifiers) {
    Nest(specifiers.structure);
    if (specifiers.enumeration == nullptr) return;
    for (const Enumerator& constant : specifiers.enumeration->enumerators) Nest(constant.value);
  }
  void Nest(const TypeName& type) {
    Nest(type.specifiers);
    for (const ExpressionPtr& size : type.sizes) Nest(size);
  }
  void Nest(const Declarator& declarator) {
    for (const ExpressionPtr& size : declarator.sizes) Nest(size);
    Nest(declarator.initialiser);
  }
  Levels levels() const { return levels_; }

 private:
  template <typename Node>
  void Add(const std::unique_ptr<Node>& below, int deeper) {
    if (below == nullptr) return;
    levels_.depth = std::max(levels_.depth, below->levels.depth + deeper);
    levels_.height = std::max(levels_.height, below->levels.height + 1);
  }

  Levels levels_;
};

// The operand in which a row of operators goes on.
bool ContinuesRow(Expression::Kind kind, size_t operand) {
  switch (kind) {
    case Expression::Kind::kBinary:
    case Expression::Kind::kComma:
      return operand == 0;
    case Expression::Kind::kConditional:
      return operand == 2;
    default:
      return false;
  }
}

template <typename... Operands>
ExpressionPtr MakeNode(Expression::Kind kind, SourceRange range, Operands... operands) {
  ExpressionPtr result = MakeExpression(kind, range);
  (result->operands.push_back(std::move(operands)), ...);
  return result;
}

template <typename... Operands>
ExpressionPtr MakeOperation(Expression::Kind kind, const Token* op, SourceRange range,
                            Operands... operands) {
  ExpressionPtr result = MakeNode(kind, range, std::move(operands)...);
  result->op = op->text;
  result->op_range = op->range;
  return result;
}

}  // namespace

// Reports a tree that is too deep or too high, once in each statement.
bool ParserDriver::Fits(const Levels& levels, SourceRange range) {
  const bool deep = levels.depth > kDepthMax;
  if (!deep && levels.height <= kHeightMax) return true;
  if (!too_deep_reported_) {
    reporter_.Report(deep ? Code::kTooDeep : Code::kTooLong, range,
                     int64_t{deep ? kDepthMax : kHeightMax});
    too_deep_reported_ = true;
  }
  return false;
}

ExpressionPtr ParserDriver::LimitDepth(ExpressionPtr expression) {
  LevelsAbove above;
  for (size_t i = 0; i < expression->operands.size(); ++i) {
    if (ContinuesRow(expression->kind, i)) {
      above.Continue(expression->operands[i]);
    } else {
      above.Nest(expression->operands[i]);
    }
  }
  if (expression->type != nullptr) above.Nest(*expression->type);
  expression->levels = above.levels();
  if (Fits(expression->levels, expression->range)) return expression;
  return MakeExpression(Expression::Kind::kError, expression->range);
}

StatementPtr ParserDriver::LimitDepth(StatementPtr statement) {
  LevelsAbove above;
  above.Nest(statement->initial);
  above.Nest(statement->body);
  if (statement->else_body != nullptr && statement->else_body->kind == Statement::Kind::kIf) {
    above.Continue(statement->else_body);
  } else {
    above.Nest(statement->else_body);
  }
  for (const StatementPtr& item : statement->items) above.Nest(item);
  if (statement->function != nullptr) {
    for (const StatementPtr& item : statement->function->body) above.Nest(item);
  }
  statement->levels = above.levels();
  if (Fits(statement->levels, statement->keyword)) return statement;
  return MakeStatement(Statement::Kind::kError, statement->range);
}

ExpressionPtr ParserDriver::Binary(Expression::Kind kind, ExpressionPtr left, const Token* op,
                                   ExpressionPtr right, SourceRange range) {
  return LimitDepth(MakeOperation(kind, op, range, std::move(left), std::move(right)));
}

ExpressionPtr ParserDriver::Unary(Expression::Kind kind, const Token* op, ExpressionPtr operand,
                                  SourceRange range) {
  return LimitDepth(MakeOperation(kind, op, range, std::move(operand)));
}

ExpressionPtr ParserDriver::Conditional(ExpressionPtr condition, const Token* op, ExpressionPtr yes,
                                        ExpressionPtr no, SourceRange range) {
  return LimitDepth(MakeOperation(Expression::Kind::kConditional, op, range, std::move(condition),
                                  std::move(yes), std::move(no)));
}

ExpressionPtr ParserDriver::Cast(TypeNamePtr type, ExpressionPtr operand, SourceRange range) {
  ExpressionPtr result = MakeNode(Expression::Kind::kCast, range, std::move(operand));
  // Only a single word can be the type of a cast.
  const std::vector<const Token*>& words = type->specifiers.words;
  if (words.size() == 1 && !type->pointer) result->text = words[0]->text;
  result->op_range = type->specifiers.range;
  result->type = std::move(type);
  return LimitDepth(std::move(result));
}

ExpressionPtr ParserDriver::CompoundLiteral(TypeNamePtr type, ExpressionPtr values,
                                            SourceRange range) {
  ExpressionPtr result = MakeNode(Expression::Kind::kCompoundLiteral, range, std::move(values));
  result->type = std::move(type);
  return LimitDepth(std::move(result));
}

ExpressionPtr ParserDriver::SizeOf(ExpressionPtr operand, SourceRange range) {
  return LimitDepth(MakeNode(Expression::Kind::kSizeof, range, std::move(operand)));
}

ExpressionPtr ParserDriver::SizeOfType(TypeNamePtr type, SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kSizeof, range);
  result->type = std::move(type);
  return LimitDepth(std::move(result));
}

ExpressionPtr ParserDriver::Index(ExpressionPtr array, ExpressionPtr index, SourceRange range) {
  return LimitDepth(MakeNode(Expression::Kind::kIndex, range, std::move(array), std::move(index)));
}

ExpressionPtr ParserDriver::Call(ExpressionPtr callee, std::vector<ExpressionPtr> arguments,
                                 SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kCall, range);
  result->operands = PutFirst(std::move(callee), std::move(arguments));
  return LimitDepth(std::move(result));
}

ExpressionPtr ParserDriver::Member(ExpressionPtr structure, const Token* op, const Token* name,
                                   SourceRange range) {
  ExpressionPtr result = MakeOperation(Expression::Kind::kMember, op, range, std::move(structure));
  result->op_range = name->range;
  result->text = name->text;
  return LimitDepth(std::move(result));
}

ExpressionPtr ParserDriver::Paren(ExpressionPtr inner, SourceRange range) {
  return LimitDepth(MakeNode(Expression::Kind::kParen, range, std::move(inner)));
}

ExpressionPtr ParserDriver::Braces(std::vector<ExpressionPtr> values, SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kBraces, range);
  result->operands = std::move(values);
  return LimitDepth(std::move(result));
}

ExpressionPtr ParserDriver::Designated(std::vector<ExpressionPtr> designators,
                                       ExpressionPtr value) {
  for (; !designators.empty(); designators.pop_back()) {
    ExpressionPtr designated = std::move(designators.back());
    designated->range = Join(designated->range, value->range);
    designated->operands = PutFirst(std::move(value), std::move(designated->operands));
    value = LimitDepth(std::move(designated));
  }
  return value;
}

StatementPtr ParserDriver::ExpressionStatement(ExpressionPtr value, SourceRange range) {
  too_deep_reported_ = false;
  StatementPtr statement = MakeStatement(
      value == nullptr ? Statement::Kind::kEmpty : Statement::Kind::kExpression, range);
  statement->value = std::move(value);
  return statement;
}

StatementPtr ParserDriver::BrokenStatement(ExpressionPtr value, SourceRange range) {
  if (resume_) return ExpressionStatement(std::move(value), range);
  return MakeStatement(Statement::Kind::kError, range);
}

StatementPtr ParserDriver::If(SourceRange keyword, ExpressionPtr condition, StatementPtr body,
                              SourceRange else_keyword, StatementPtr else_body, SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kIf, range);
  statement->keyword = keyword;
  statement->value = std::move(condition);
  statement->body = std::move(body);
  statement->other = else_keyword;
  statement->else_body = std::move(else_body);
  return LimitDepth(std::move(statement));
}

StatementPtr ParserDriver::Loop(Statement::Kind kind, SourceRange keyword, ExpressionPtr condition,
                                StatementPtr body, SourceRange range) {
  StatementPtr statement = MakeStatement(kind, range);
  statement->keyword = keyword;
  statement->value = std::move(condition);
  statement->body = std::move(body);
  return LimitDepth(std::move(statement));
}

StatementPtr ParserDriver::For(SourceRange keyword, StatementPtr initial, ExpressionPtr condition,
                               ExpressionPtr step, StatementPtr body, SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kFor, range);
  statement->keyword = keyword;
  statement->initial = std::move(initial);
  statement->value = std::move(condition);
  statement->step = std::move(step);
  statement->body = std::move(body);
  return LimitDepth(std::move(statement));
}

StatementPtr ParserDriver::Return(SourceRange keyword, ExpressionPtr value, SourceRange range) {
  too_deep_reported_ = false;
  StatementPtr statement = MakeStatement(Statement::Kind::kReturn, range);
  statement->keyword = keyword;
  statement->value = std::move(value);
  return statement;
}

void ParserDriver::AddPrototypes(Function& first, std::vector<std::unique_ptr<Function>> others) {
  first.prototype = true;
  for (const std::unique_ptr<Function>& other : others) {
    if (dialect_ == Dialect::kCard) {
      skipped_names_.insert(other->name);
      reporter_.Report(Code::kUnexpected, other->name_range,
                       ToMessage(fmt::format("'{}'", other->name)),
                       MakeMessage("a declaration of its own", "单独的声明"));
      continue;
    }
    other->prototype = true;
    other->specifiers.range = first.specifiers.range;
    other->specifiers.words = first.specifiers.words;
    other->close_brace = first.close_brace;
  }
  if (dialect_ == Dialect::kStructured) first.others = std::move(others);
}

std::unique_ptr<StructSpecifier> ParserDriver::DefinedStruct(
    std::unique_ptr<StructSpecifier> structure, std::vector<StatementPtr> members) {
  LevelsAbove above;
  for (const StatementPtr& member : members) {
    above.Nest(member->specifiers);
    for (const Declarator& declarator : member->declarators) above.Nest(declarator);
  }
  structure->defined = true;
  structure->levels = above.levels();
  if (Fits(structure->levels, structure->range)) {
    structure->members = std::move(members);
  } else {
    structure->levels = {};
    structure->members.push_back(MakeStatement(Statement::Kind::kError, structure->range));
  }
  return structure;
}

StatementPtr ParserDriver::FunctionItem(std::unique_ptr<Function> function, SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kFunction, range);
  statement->keyword = function->header;
  statement->function = std::move(function);
  return LimitDepth(std::move(statement));
}

StatementPtr ParserDriver::Block(std::vector<StatementPtr> items, SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kBlock, range);
  statement->items = std::move(items);
  statement->keyword = range;
  statement->keyword.end = range.begin + 1;
  return LimitDepth(std::move(statement));
}

StatementPtr ParserDriver::Labelled(std::vector<StatementPtr> labels, StatementPtr statement,
                                    SourceRange range) {
  StatementPtr block = MakeStatement(Statement::Kind::kBlock, range);
  block->keyword = labels.front()->range;
  block->items = std::move(labels);
  block->items.push_back(std::move(statement));
  return LimitDepth(std::move(block));
}

SourceRange Join(SourceRange first, SourceRange last) {
  if (first.file != last.file || last.end < first.begin) return last;
  return {first.file, first.begin, last.end};
}

void Append(std::vector<StatementPtr>& items, StatementPtr item) {
  items.push_back(std::move(item));
}

StatementPtr MakeStatement(Statement::Kind kind, SourceRange range) {
  StatementPtr statement = std::make_unique<Statement>();
  statement->kind = kind;
  statement->range = statement->keyword = range;
  return statement;
}

StatementPtr MakeNamed(Statement::Kind kind, const Token* name, SourceRange name_range,
                       SourceRange range) {
  StatementPtr statement = MakeStatement(kind, range);
  statement->name = name->text;
  statement->name_range = name_range;
  return statement;
}

StatementPtr MakeDeclaration(Specifiers specifiers, std::vector<Declarator> declarators,
                             SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kDeclaration, range);
  statement->keyword = specifiers.range;
  statement->specifiers = std::move(specifiers);
  statement->declarators = std::move(declarators);
  return statement;
}

std::unique_ptr<Enumeration> MakeEnumeration(const Token* name, SourceRange range) {
  auto enumeration = std::make_unique<Enumeration>();
  enumeration->range = range;
  if (name != nullptr) {
    enumeration->name = name->text;
    enumeration->name_range = name->range;
  }
  return enumeration;
}

std::unique_ptr<StructSpecifier> MakeStruct(const Token* name, SourceRange range) {
  auto structure = std::make_unique<StructSpecifier>();
  structure->range = range;
  if (name != nullptr) {
    structure->name = name->text;
    structure->name_range = name->range;
    structure->tag = fmt::format("struct {}", name->text);
  }
  return structure;
}

StatementPtr MakeCase(SourceRange keyword, ExpressionPtr value, ExpressionPtr last,
                      SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kCase, range);
  statement->keyword = keyword;
  statement->value = std::move(value);
  statement->last = std::move(last);
  return statement;
}

TypeNamePtr MakeTypeName(Specifiers specifiers, bool pointer, std::vector<ExpressionPtr> sizes,
                         SourceRange range) {
  auto type = std::make_unique<TypeName>();
  type->range = range;
  type->specifiers = std::move(specifiers);
  type->pointer = pointer;
  type->sizes = std::move(sizes);
  return type;
}

std::vector<ExpressionPtr> PutFirst(ExpressionPtr first, std::vector<ExpressionPtr> others) {
  others.insert(others.begin(), std::move(first));
  return others;
}

ExpressionPtr MakeExpression(Expression::Kind kind, SourceRange range) {
  ExpressionPtr expression = std::make_unique<Expression>();
  expression->kind = kind;
  expression->range = range;
  return expression;
}

ExpressionPtr MakeLiteral(const Token* token, SourceRange range) {
  ExpressionPtr expression = MakeExpression(Expression::Kind::kLiteral, range);
  expression->literal = token->literal;
  expression->text = token->text;
  return expression;
}

ExpressionPtr MakeDesignator(ExpressionPtr first, ExpressionPtr last, SourceRange range) {
  ExpressionPtr designator = MakeExpression(Expression::Kind::kDesignated, range);
  designator->op_range = range;
  designator->operands.push_back(std::move(first));
  if (last != nullptr) designator->operands.push_back(std::move(last));
  return designator;
}

ExpressionPtr MakeDesignator(const Token* name, SourceRange range) {
  ExpressionPtr designator = MakeExpression(Expression::Kind::kDesignated, range);
  designator->op_range = name->range;
  designator->text = name->text;
  return designator;
}

Declarator MakeRows(const Token* name, std::vector<ExpressionPtr> sizes, SourceRange range) {
  Declarator rows;
  if (name != nullptr) {
    rows.name = name->text;
    rows.name_range = name->range;
  }
  rows.range = rows.head = range;
  if (sizes.empty()) {
    rows.pointer = 1;
  } else {
    rows.sizes = PutFirst(nullptr, std::move(sizes));
  }
  return rows;
}

std::unique_ptr<Function> MakeFunction(Specifiers specifiers, bool pointer, const Token* name,
                                       std::vector<ParameterDeclaration> parameters,
                                       SourceRange range) {
  auto function = std::make_unique<Function>();
  function->header = range;
  function->name = name->text;
  function->name_range = name->range;
  function->specifiers = std::move(specifiers);
  function->pointer = pointer;
  function->parameters = std::move(parameters);
  return function;
}

void CloseFunction(Function& function, SourceRange open_brace, std::vector<StatementPtr> body,
                   SourceRange close_brace) {
  function.open_brace = open_brace;
  function.close_brace = close_brace;
  function.body = std::move(body);
}

}  // namespace oncard::compiler
