#include "compiler/check_context.h"

#include <algorithm>

#include "compiler/parser.hh"
#include "vm/limits.h"

namespace oncard::compiler {

CheckContext::CheckContext(const Options& all_options, const std::deque<SourceFile>& all_files,
                           Reporter& the_reporter, const std::vector<Token>& tokens)
    : options(all_options),
      catalogue(*all_options.catalogue),
      files(all_files),
      reporter(the_reporter) {
  object.double_format = options.double_format;
  for (const Token& token : tokens) {
    if (token.kind == Parser::token::kName) fresh.Reserve(token.text);
  }
  first_item = tokens.front().range;
  for (const Token& token : tokens) {
    if (token.range.file != 0) continue;
    first_item = token.range;
    break;
  }
}

std::string_view CheckContext::Source(SourceRange range) const {
  const std::string_view text = files[static_cast<size_t>(range.file)].text();
  return text.substr(range.begin, range.end - range.begin);
}

int CheckContext::LineOf(SourceRange range) const {
  return files[static_cast<size_t>(range.file)].LineOf(range.begin);
}

const Entity* CheckContext::Lookup(std::string_view name) const {
  if (function != nullptr) {
    if (const Entity* local = function->locals.Find(name)) return local;
  }
  return globals.Find(name);
}

// A constant may be negated once: `-1`, `-LIMIT`. The card's compiler computes nothing else.
std::optional<Literal> CheckContext::ConstantOf(const Expression& expression) const {
  if (expression.kind == Expression::Kind::kLiteral) return expression.literal;
  if (expression.kind == Expression::Kind::kName) {
    const Entity* entity = Lookup(expression.text);
    if (entity != nullptr && entity->kind == Entity::Kind::kMacro) return entity->value;
  }
  if (expression.kind == Expression::Kind::kUnary && expression.op == "-") {
    const Expression& inner = *expression.operands[0];
    if (inner.kind != Expression::Kind::kLiteral && inner.kind != Expression::Kind::kName) {
      return std::nullopt;
    }
    std::optional<Literal> literal = ConstantOf(inner);
    if (literal) literal->negative = !literal->negative;
    return literal;
  }
  return std::nullopt;
}

std::optional<Constant> CheckContext::FoldHere(const Expression& expression) const {
  return Fold(expression, [this](std::string_view name) -> std::optional<Literal> {
    const Entity* entity = Lookup(name);
    if (entity == nullptr) return TruthValue(name);
    if (entity->kind != Entity::Kind::kMacro) return std::nullopt;
    return entity->value;
  });
}

NameUses CheckContext::UsesInFunction(std::string_view name) {
  std::optional<NameTable>& uses = function->uses;
  if (!uses) uses.emplace().Add(function->syntax->body);
  return uses->Find(name);
}

// True if a block declares a name with another meaning outside; the name must be changed first.
bool CheckContext::NeedsBraces(const Statement& block) const {
  return std::any_of(block.items.begin(), block.items.end(), [this](const StatementPtr& item) {
    return std::any_of(item->declarators.begin(), item->declarators.end(),
                       [this](const Declarator& declarator) {
                         return function->declarations.at(declarator.name) > 1 ||
                                globals.Find(declarator.name) != nullptr;
                       });
  });
}

void CheckContext::Emit(vm::Instruction instruction) {
  FunctionState& in = *function;
  if (in.out.instructions.size() == vm::kInstructionMax) {
    if (!in.too_long) {
      in.too_long = true;
      reporter.Report(Code::kFunctionTooLong, statement.range, in.syntax->name,
                      int64_t{vm::kInstructionMax} + 1, int64_t{vm::kInstructionMax});
    }
    return;
  }
  in.out.instructions.push_back(std::move(instruction));
  in.out.lines.push_back(statement.line);
  in.places.statements.push_back(statement.range);
}

}  // namespace oncard::compiler
