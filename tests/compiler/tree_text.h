// Writes a syntax tree as text, for tests of the parser: prefix notation, one bracket per node.
#pragma once

#include <string>

#include "compiler/syntax.h"

namespace oncard::compiler {

inline std::string TreeText(const Expression* expression);
inline std::string TreeText(const Statement* statement);

inline std::string SizesText(const std::vector<ExpressionPtr>& sizes) {
  std::string text;
  for (const ExpressionPtr& size : sizes) text += '[' + TreeText(size.get()) + ']';
  return text;
}

inline std::string TreeText(const Specifiers& specifiers) {
  std::string text;
  for (const Token* word : specifiers.words) {
    text += (text.empty() ? "" : " ") + std::string(word->text);
  }
  if (specifiers.structure != nullptr) {
    const StructSpecifier& structure = *specifiers.structure;
    text += std::string(text.empty() ? "" : " ") + "struct " + std::string(structure.name);
    if (!structure.defined) return text;
    text += '{';
    for (const StatementPtr& member : structure.members) text += ' ' + TreeText(member.get());
    return text + " }";
  }
  if (specifiers.enumeration == nullptr) return text;
  const Enumeration& enumeration = *specifiers.enumeration;
  text += std::string(text.empty() ? "" : " ") + "enum " + std::string(enumeration.name);
  if (!enumeration.defined) return text;
  text += '{';
  for (const Enumerator& constant : enumeration.enumerators) {
    text += ' ' + std::string(constant.name);
    if (constant.value != nullptr) text += '=' + TreeText(constant.value.get());
  }
  return text + " }";
}

inline std::string TreeText(const TypeName& type) {
  return TreeText(type.specifiers) + (type.pointer ? "*" : "") + SizesText(type.sizes);
}

inline std::string TreeText(const Expression* expression) {
  if (expression == nullptr) return "";
  std::string head;
  switch (expression->kind) {
    case Expression::Kind::kName:
    case Expression::Kind::kString:
    case Expression::Kind::kLiteral:
      return std::string(expression->text);
    case Expression::Kind::kIndex:
      head = "index";
      break;
    case Expression::Kind::kMember:
      head = std::string(expression->op) + std::string(expression->text);
      break;
    case Expression::Kind::kPostfix:
      head = "post" + std::string(expression->op);
      break;
    case Expression::Kind::kCast:
      head = "cast " + TreeText(*expression->type);
      break;
    case Expression::Kind::kSizeof:
      head = "sizeof" + (expression->type != nullptr ? ' ' + TreeText(*expression->type) : "");
      break;
    case Expression::Kind::kCall:
      head = "call";
      break;
    case Expression::Kind::kConditional:
      head = "?";
      break;
    case Expression::Kind::kComma:
      head = ",";
      break;
    case Expression::Kind::kParen:
      head = "paren";
      break;
    case Expression::Kind::kDesignated:
      head = expression->text.empty() ? "at" : '.' + std::string(expression->text);
      break;
    case Expression::Kind::kBraces:
      head = "values";
      break;
    case Expression::Kind::kError:
      head = "error";
      break;
    default:
      head = expression->op;
  }
  std::string text = '(' + head;
  for (const ExpressionPtr& operand : expression->operands) text += ' ' + TreeText(operand.get());
  return text + ')';
}

inline std::string TreeText(const Declarator& declarator) {
  std::string text =
      (declarator.pointer ? "*" : "") + std::string(declarator.name) + SizesText(declarator.sizes);
  if (declarator.initialiser != nullptr) text += '=' + TreeText(declarator.initialiser.get());
  return text;
}

inline std::string TreeText(const std::vector<StatementPtr>& items);

inline std::string TreeText(const compiler::Function& function) {
  std::string text = '(' + TreeText(function.specifiers) + (function.pointer ? "*" : "") + ' ' +
                     std::string(function.name) + " (";
  for (size_t i = 0; i < function.parameters.size(); ++i) {
    const ParameterDeclaration& parameter = function.parameters[i];
    if (i > 0) text += ", ";
    text += TreeText(parameter.specifiers);
    const std::string declarator = TreeText(parameter.declarator);
    text += (declarator.empty() ? "" : " ") + declarator;
  }
  text += ')';
  if (!function.prototype) text += " {" + TreeText(function.body) + '}';
  return text + ')';
}

inline std::string TreeText(const Statement* statement) {
  if (statement == nullptr) return "";
  const std::string value = TreeText(statement->value.get());
  const std::string body = TreeText(statement->body.get());
  switch (statement->kind) {
    case Statement::Kind::kEmpty:
      return "empty";
    case Statement::Kind::kExpression:
      return value;
    case Statement::Kind::kDeclaration: {
      std::string text = "(decl " + TreeText(statement->specifiers);
      for (const Declarator& declarator : statement->declarators) {
        text += ' ' + TreeText(declarator);
      }
      return text + ')';
    }
    case Statement::Kind::kIf: {
      const std::string otherwise = TreeText(statement->else_body.get());
      return "(if " + value + ' ' + body + (otherwise.empty() ? "" : " else " + otherwise) + ')';
    }
    case Statement::Kind::kWhile:
      return "(while " + value + ' ' + body + ')';
    case Statement::Kind::kDo:
      return "(do " + body + " while " + value + ')';
    case Statement::Kind::kFor:
      return "(for " + TreeText(statement->initial.get()) + "; " + value + "; " +
             TreeText(statement->step.get()) + "; " + body + ')';
    case Statement::Kind::kSwitch:
      return "(switch " + value + ' ' + body + ')';
    case Statement::Kind::kCase: {
      const std::string last = TreeText(statement->last.get());
      return "(case " + value + (last.empty() ? "" : " ... " + last) + ')';
    }
    case Statement::Kind::kDefault:
      return "default";
    case Statement::Kind::kLabel:
      return "(label " + std::string(statement->name) + ')';
    case Statement::Kind::kGoto:
      return "(goto " + std::string(statement->name) + ')';
    case Statement::Kind::kReturn:
      return value.empty() ? "return" : "(return " + value + ')';
    case Statement::Kind::kBreak:
      return "break";
    case Statement::Kind::kContinue:
      return "continue";
    case Statement::Kind::kBlock:
      return '{' + TreeText(statement->items) + '}';
    case Statement::Kind::kFunction:
      return TreeText(*statement->function);
    case Statement::Kind::kMacro:
      return "macro";
    case Statement::Kind::kStrayBrace:
      return "stray";
    case Statement::Kind::kError:
      return "error";
  }
  return "";
}

inline std::string TreeText(const std::vector<StatementPtr>& items) {
  std::string text;
  for (const StatementPtr& item : items) text += (text.empty() ? "" : " ") + TreeText(item.get());
  return text;
}

}  // namespace oncard::compiler
