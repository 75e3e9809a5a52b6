#include "compiler/structured_refusals.h"

#include <fmt/core.h>

#include <algorithm>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "compiler/header_types.h"
#include "compiler/operands.h"
#include "compiler/parser.hh"
#include "compiler/tree_walk.h"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;
using EKind = Expression::Kind;
using SKind = Statement::Kind;

constexpr std::string_view kTypes =
    "void, bool, char, short, int, long, double, an enum, a struct, TTrapPrm, TJogPrm, TPid";

bool IsIn(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

Message WhyDefinedBefore() {
  return MakeMessage("define it before, in a declaration of its own",
                     "请在此之前用单独的声明定义它");
}

// What a message calls a declarator that may have no name.
std::string_view NameOrWord(const Declarator& declarator) {
  return declarator.name.empty() ? "*" : declarator.name;
}

class Refusals {
 public:
  Refusals(const std::unordered_set<std::string_view>& type_names,
           const std::unordered_set<std::string_view>& skipped_names, const Options& options,
           Reporter& reporter)
      : type_names_(type_names),
        skipped_names_(skipped_names),
        options_(options),
        reporter_(reporter) {}

  void FindNeeded(const Tree& tree);
  void VisitTopLevel(const Statement& item);

 private:
  // A pointer is reported by itself: its type may be void.
  enum class Use : uint8_t { kVariable, kParameter, kFunction, kCast, kPointer };

  void Excuse(const Function& function, size_t known);
  void VisitFunction(const Function& function);
  void VisitHead(const Function& function);
  bool IsReference(const ParameterDeclaration& parameter) const;
  void VisitStatement(const Statement& statement);
  void VisitBody(const Statement* body, std::string_view word);
  void VisitDeclaration(const Statement& statement);
  Diagnostic& ReportPointer(const Declarator& declarator, SourceRange place);
  void VisitSizesAndValues(const Declarator& declarator);
  void VisitSpecifiers(const Specifiers& specifiers, Use use);
  void VisitStructure(const StructSpecifier& structure, Use use);
  void VisitMember(const Statement& member);
  void VisitType(const TypeName& type);
  void Visit(const Expression* expression);
  void VisitCall(const Expression& call);
  void VisitNumber(const Expression& expression, bool negated);
  void TooLarge(const Expression& number, const Message& type, const Message& lowest,
                const Message& highest);

  const std::unordered_set<std::string_view>& type_names_;
  const std::unordered_set<std::string_view>& skipped_names_;
  const Options& options_;
  Reporter& reporter_;
  std::unordered_set<std::string_view> needed_;
  std::string_view function_;  // the one whose body is visited
};

// Only definitions are allowed at the top level.
void Refusals::VisitTopLevel(const Statement& item) {
  switch (item.kind) {
    case SKind::kFunction:
      VisitFunction(*item.function);
      return;
    case SKind::kDeclaration:
      VisitDeclaration(item);
      return;
    case SKind::kStrayBrace:
      Replace(reporter_.Report(Code::kStrayBrace, item.range), item.range, "");
      return;
    case SKind::kEmpty:
    case SKind::kMacro:
    case SKind::kError:
      return;
    default:
      reporter_.Report(Code::kOutsideFunction, item.keyword);
  }
}

// Finds the functions whose statements are part of the program: those that are not static, and what
// they call.
void Refusals::FindNeeded(const Tree& tree) {
  std::unordered_set<std::string_view> statics;
  std::unordered_map<std::string_view, const Function*> functions;
  for (const StatementPtr& item : tree.items) {
    if (item->kind != SKind::kFunction) continue;
    const Function& function = *item->function;
    for (const Token* word : function.specifiers.words) {
      if (word->kind == Kind::kStatic) statics.insert(function.name);
    }
    if (!function.prototype) functions.emplace(function.name, &function);
  }
  std::vector<const Function*> open;
  for (const auto& [name, function] : functions) {
    if (!statics.contains(name)) open.push_back(function);
  }
  while (!open.empty()) {
    const Function& function = *open.back();
    open.pop_back();
    if (!needed_.insert(function.name).second) continue;
    const auto in_expression = [&](const Expression& expression) {
      const auto callee = functions.find(expression.text);
      if (callee != functions.end()) open.push_back(callee->second);
    };
    for (const StatementPtr& item : function.body) {
      ForEachStatement(*item, [&](const Statement& statement) {
        ForEachWholeExpression(
            statement, [&](const Expression& whole) { ForEachExpression(whole, in_expression); });
      });
    }
  }
}

// Makes a remark of the errors since `known`, which are about a function that is not needed.
void Refusals::Excuse(const Function& function, size_t known) {
  std::deque<Diagnostic>& all = reporter_.diagnostics();
  if (all.size() == known) return;
  const Diagnostic first = std::move(all[known]);
  all.resize(known);
  AddNote(
      reporter_.Report(Code::kUnneededFunction, function.name_range, function.name, first.message),
      first.range, MakeMessage("this is the first obstacle", "第一处障碍在此"));
}

void Refusals::VisitFunction(const Function& function) {
  if (!function_.empty() && !function.prototype) {
    reporter_.Report(Code::kNestedFunction, function.name_range, function.name, function_);
    return;
  }
  const size_t known = reporter_.diagnostics().size();
  VisitSpecifiers(function.specifiers, Use::kFunction);
  VisitHead(function);
  for (const std::unique_ptr<Function>& other : function.others) VisitHead(*other);
  if (function.prototype) return;
  function_ = function.name;
  for (const StatementPtr& item : function.body) VisitStatement(*item);
  function_ = {};
  if (!needed_.contains(function.name)) Excuse(function, known);
}

// `int *a`: a number or an array of the caller.
bool Refusals::IsReference(const ParameterDeclaration& parameter) const {
  const std::vector<const Token*>& words = parameter.specifiers.words;
  return parameter.declarator.pointer == 1 && parameter.declarator.sizes.empty() &&
         std::none_of(words.begin(), words.end(),
                      [](const Token* word) { return word->kind == Kind::kVoid; });
}

// The name and the parameters.
void Refusals::VisitHead(const Function& function) {
  if (function.pointer) reporter_.Report(Code::kPointer, function.name_range, function.name);
  for (const ParameterDeclaration& parameter : function.parameters) {
    const Declarator& declarator = parameter.declarator;
    const Specifiers& specifiers = parameter.specifiers;
    if (specifiers.words.empty() && specifiers.enumeration == nullptr &&
        specifiers.structure == nullptr) {
      if (function.mended) continue;
      InsertBefore(reporter_.Report(Code::kOldStyle, parameter.range, declarator.name),
                   parameter.range, "int ");
      continue;
    }
    const bool nothing = function.parameters.size() == 1 && declarator.name.empty() &&
                         specifiers.words.size() == 1 && specifiers.words[0]->text == "void";
    if (nothing && !declarator.pointer && declarator.sizes.empty()) continue;
    const bool reference = IsReference(parameter);
    VisitSpecifiers(specifiers,
                    declarator.pointer > 0 && !reference ? Use::kPointer : Use::kParameter);
    if (declarator.pointer > 0 && !reference) {
      AddNote(ReportPointer(declarator,
                            declarator.name.empty() ? parameter.range : declarator.name_range),
              MakeMessage(
                  "a parameter may be 'int *{0}' for a number or an array of the caller, with "
                  "one star and a type of numbers or a struct",
                  "参数可以写作 'int *{0}'，代表调用者的数或数组：只有一个星号，类型为数或 struct",
                  NameOrWord(declarator)));
    }
    VisitSizesAndValues(declarator);
    if (!function.prototype && declarator.name.empty()) {
      SourceRange end = parameter.range;
      end.begin = end.end;
      reporter_.Report(Code::kExpectedName, end, MakeMessage("only a type", "只有类型"));
    }
  }
}

void Refusals::VisitStatement(const Statement& statement) {
  if (statement.kind == SKind::kDeclaration) {
    VisitDeclaration(statement);
    return;
  }
  if (statement.kind == SKind::kFunction) {
    VisitFunction(*statement.function);
    return;
  }
  ForEachWholeExpression(statement, [this](const Expression& whole) { Visit(&whole); });
  if (statement.initial != nullptr) VisitStatement(*statement.initial);
  const std::string_view word = statement.kind == SKind::kIf       ? "if"
                                : statement.kind == SKind::kWhile  ? "while"
                                : statement.kind == SKind::kDo     ? "do"
                                : statement.kind == SKind::kSwitch ? "switch"
                                                                   : "for";
  VisitBody(statement.body.get(), word);
  VisitBody(statement.else_body.get(), "else");
  for (const StatementPtr& item : statement.items) VisitStatement(*item);
}

void Refusals::VisitBody(const Statement* body, std::string_view word) {
  if (body == nullptr) return;
  // Labels stand before the statement itself.
  const bool labelled = body->kind == SKind::kBlock && body->keyword.end - body->keyword.begin > 1;
  const Statement& statement = labelled ? *body->items.back() : *body;
  if (statement.kind == SKind::kDeclaration) {
    reporter_.Report(Code::kDeclarationAsBody, statement.range, word);
  }
  VisitStatement(*body);
}

void Refusals::VisitDeclaration(const Statement& statement) {
  const std::vector<Declarator>& declarators = statement.declarators;
  const bool pointers = std::any_of(declarators.begin(), declarators.end(),
                                    [](const Declarator& one) { return one.pointer; });
  VisitSpecifiers(statement.specifiers, pointers ? Use::kPointer : Use::kVariable);
  for (const Declarator& declarator : declarators) {
    if (declarator.pointer) {
      AddNote(ReportPointer(declarator, declarator.name_range),
              MakeMessage("use the variable or the array itself, with an index in place of '{0}'",
                          "请直接使用变量或数组，并以下标代替 '{0}'", NameOrWord(declarator)));
    }
    VisitSizesAndValues(declarator);
  }
}

Diagnostic& Refusals::ReportPointer(const Declarator& declarator, SourceRange place) {
  return reporter_.Report(Code::kPointer, place, NameOrWord(declarator));
}

void Refusals::VisitSizesAndValues(const Declarator& declarator) {
  for (const ExpressionPtr& size : declarator.sizes) Visit(size.get());
  Visit(declarator.initialiser.get());
}

void Refusals::VisitStructure(const StructSpecifier& structure, Use use) {
  if (!structure.defined) return;
  const auto refuse = [this, &structure](const Message& why) {
    reporter_.Report(Code::kNotForTheCard, structure.range, std::string_view("struct"), why);
  };
  if (use != Use::kVariable && use != Use::kPointer) refuse(WhyDefinedBefore());
  if (structure.members.empty()) refuse(MakeMessage("it has no members", "它没有成员"));
  for (const StatementPtr& member : structure.members) VisitMember(*member);
}

// The declaration of members.
void Refusals::VisitMember(const Statement& member) {
  const size_t known = reporter_.diagnostics().size();
  if (member.kind == SKind::kDeclaration) VisitDeclaration(member);
  if (reporter_.diagnostics().size() > known) return;
  const auto refuse = [this](SourceRange range, std::string_view what, const Message& why) {
    reporter_.Report(Code::kNotForTheCard, range, what, why);
  };
  if (member.declarators.empty() && member.specifiers.structure != nullptr) {
    refuse(member.specifiers.range, "struct",
           MakeMessage("a member needs a name, by which it is used", "成员需要名称，以便使用"));
  }
  for (const Token* word : member.specifiers.words) {
    if (IsIn(word->text, {"static", "extern", "typedef"})) {
      refuse(
          word->range, word->text,
          MakeMessage("it cannot stand before a member; leave it out", "它不能用于成员；请去掉它"));
    }
  }
  for (const Declarator& declarator : member.declarators) {
    if (!declarator.sizes.empty() && declarator.sizes[0] == nullptr) {
      refuse(declarator.head, declarator.name,
             MakeMessage("a member has as many elements as its declaration says; write the size",
                         "成员的元素个数由声明确定；请写出长度"));
    }
    if (declarator.initialiser != nullptr) {
      refuse(declarator.initialiser->range, declarator.name,
             MakeMessage("a member has no value; give one to the variable",
                         "成员没有初值；请在变量处给出"));
    }
  }
}

// The words of a type are one of the types of kTypes, and together one that C has.
void Refusals::VisitSpecifiers(const Specifiers& specifiers, Use use) {
  if (specifiers.enumeration != nullptr) {
    if (specifiers.enumeration->defined && use != Use::kVariable) {
      reporter_.Report(Code::kNotForTheCard, specifiers.enumeration->range,
                       std::string_view("enum"), WhyDefinedBefore());
    }
    for (const Enumerator& constant : specifiers.enumeration->enumerators) {
      Visit(constant.value.get());
    }
  }
  if (specifiers.structure != nullptr) VisitStructure(*specifiers.structure, use);
  std::string spelled;
  std::string_view base = specifiers.enumeration != nullptr ? "enum"
                          : specifiers.structure != nullptr ? "struct"
                                                            : "";
  int longs = 0;
  int shorts = 0;
  int signs = 0;
  bool good = true;
  for (const Token* word : specifiers.words) {
    const std::string_view text = word->text;
    if (!spelled.empty()) spelled += ' ';
    spelled += text;
    if (word->kind == Kind::kTypedef) {
      good = good && (use == Use::kVariable || use == Use::kPointer || use == Use::kFunction);
      if (use == Use::kFunction) {
        reporter_.Report(Code::kNotForTheCard, word->range, text,
                         MakeMessage("functions have no types of their own here; call them by name",
                                     "此处函数没有自己的类型；请用名称调用"));
      }
      continue;
    }
    if (word->kind == Kind::kStatic || word->kind == Kind::kConst || word->kind == Kind::kExtern ||
        word->kind == Kind::kQualifier) {
      const bool allowed =
          use == Use::kVariable || use == Use::kFunction || use == Use::kPointer ||
          IsIn(text, {"const", "volatile", "__volatile", "__volatile__", "register"});
      good = good && allowed;
      continue;
    }
    if (text == "long") {
      ++longs;
    } else if (text == "short") {
      ++shorts;
    } else if (IsIn(text, {"signed", "unsigned"})) {
      ++signs;
    } else {
      good = good && base.empty();
      base = text;
    }
  }
  const bool sized = longs + shorts > 0;
  const std::string_view header_type = TypeForHeaderType(base);
  if ((longs == 2 && shorts == 0 && signs <= 1 && IsIn(base, {"", "int"})) ||
      header_type.ends_with("long long")) {
    reporter_.Report(Code::kLongLong, specifiers.range, spelled);
    return;
  }
  if (base == "float" || (base == "double" && longs == 1)) {
    Diagnostic& diagnostic =
        reporter_.Report(Code::kForeignType, specifiers.range, spelled, std::string_view("double"));
    if (specifiers.words.size() == 1) Replace(diagnostic, specifiers.range, "double");
    return;
  }
  if (sized || signs > 0) {
    good = good && longs + shorts <= 1 && signs <= 1 &&
           (IsIn(base, {"", "int"}) || (base == "char" && !sized));
  } else {
    const gtcalls::Structure* structure = options_.catalogue->FindStructure(base);
    good =
        good &&
        (IsIn(base, {"bool", "_Bool", "char", "int", "double", "enum", "struct"}) ||
         !header_type.empty() || type_names_.contains(base) ||
         (base == "void" && (use == Use::kFunction || use == Use::kCast || use == Use::kPointer)) ||
         (structure != nullptr && structure->in_motion_program));
  }
  const bool skipped = specifiers.words.size() == 1 && skipped_names_.contains(base);
  if (good || skipped) return;
  Diagnostic& diagnostic = reporter_.Report(Code::kNotAType, specifiers.range,
                                            ToMessage(fmt::format("'{}'", spelled)), kTypes);
  // `static n;`: C had it before 1999.
  const bool left_out = base.empty() && !sized && signs == 0 && use != Use::kCast;
  if (left_out) InsertAfter(diagnostic, specifiers.range, " int");
}

void Refusals::VisitType(const TypeName& type) {
  VisitSpecifiers(type.specifiers, Use::kCast);
  if (type.pointer) reporter_.Report(Code::kNeedsPointer, type.range, std::string_view("*"));
  for (const ExpressionPtr& size : type.sizes) Visit(size.get());
}

void Refusals::Visit(const Expression* expression) {
  if (expression == nullptr) return;
  switch (expression->kind) {
    case EKind::kLiteral:
      VisitNumber(*expression, false);
      return;
    case EKind::kString:
      reporter_.Report(Code::kStringData, expression->range, expression->text);
      return;
    case EKind::kCall:
      VisitCall(*expression);
      return;
    case EKind::kUnary: {
      const Expression& operand = *expression->operands[0];
      if (expression->op == "-" && operand.kind == EKind::kLiteral) {
        VisitNumber(operand, true);
        return;
      }
      break;
    }
    default:
      break;
  }
  if (expression->type != nullptr) VisitType(*expression->type);
  for (const ExpressionPtr& operand : expression->operands) Visit(operand.get());
}

void Refusals::VisitCall(const Expression& call) {
  const Expression& callee = *call.operands[0];
  if (callee.kind != EKind::kName && callee.kind != EKind::kError) {
    reporter_.Report(Code::kIndirectCall, callee.range);
  }
  for (size_t i = 1; i < call.operands.size(); ++i) Visit(call.operands[i].get());
}

// The number fits its type: `-2147483648` is one number, although C reads two.
void Refusals::VisitNumber(const Expression& expression, bool negated) {
  Literal literal = expression.literal;
  literal.negative = literal.negative || negated;
  if (literal.kind == Literal::Kind::kFixed) {
    if (FixedValue(literal, options_.double_format)) return;
    const auto bound = [this](bool upper) {
      return DescribeRange(vm::DataType::kDouble, options_.double_format, upper);
    };
    TooLarge(expression, DescribeType(vm::DataType::kDouble), bound(false), bound(true));
  } else if (!IntValue(literal)) {
    const bool bits = literal.as_bits || literal.is_unsigned;
    TooLarge(
        expression,
        bits ? MakeMessage("an unsigned int", "unsigned int") : DescribeType(vm::DataType::kInt),
        ToMessage(std::string_view(bits ? "0" : "-2147483648")),
        ToMessage(std::string_view(bits ? "4294967295" : "2147483647")));
  }
}

void Refusals::TooLarge(const Expression& number, const Message& type, const Message& lowest,
                        const Message& highest) {
  reporter_.Report(Code::kLiteralTooLarge, number.range, number.text, type, lowest, highest);
}

}  // namespace

void RefuseUntranslatable(const Tree& tree, const std::unordered_set<std::string_view>& type_names,
                          const std::unordered_set<std::string_view>& skipped_names,
                          const Options& options, Reporter& reporter) {
  Refusals refusals(type_names, skipped_names, options, reporter);
  refusals.FindNeeded(tree);
  for (const StatementPtr& item : tree.items) refusals.VisitTopLevel(*item);
}

}  // namespace oncard::compiler
