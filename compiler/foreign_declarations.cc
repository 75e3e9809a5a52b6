// Declarations of C that the language does not have: `const`, `static`, `extern`, `unsigned`,
// `char`, initial values of globals, names that shadow others. Each gets a fix-it if that preserves
// the meaning of the program; otherwise a note gives the reason why not.
#include <algorithm>

#include "compiler/declarations.h"
#include "compiler/operators.h"
#include "vm/limits.h"

namespace oncard::compiler {
namespace {

using vm::DataType;

bool IsAnyOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool HasWord(const Specifiers& specifiers, std::string_view word) {
  return std::any_of(specifiers.words.begin(), specifiers.words.end(),
                     [word](const Token* token) { return token->text == word; });
}

bool IsBool(const Specifiers& specifiers) {
  return HasWord(specifiers, "bool") || HasWord(specifiers, "_Bool");
}

// The operator's value is 0 or 1.
bool IsTruth(const vm::OperatorInfo& info) { return vm::IsLogical(info) || vm::IsComparison(info); }

// The range of an integer type of C.
struct Range {
  int64_t minimum = INT32_MIN;
  int64_t maximum = INT32_MAX;
  bool narrow = false;  ///< smaller range than an int
  bool is_signed = true;
};

Range RangeOf(const Specifiers& specifiers) {
  const bool is_unsigned = HasWord(specifiers, "unsigned");
  if (IsBool(specifiers)) return {0, 1, true, false};
  if (HasWord(specifiers, "char")) {
    return is_unsigned ? Range{0, UINT8_MAX, true, false} : Range{INT8_MIN, INT8_MAX, true, true};
  }
  if (is_unsigned && HasWord(specifiers, "short")) return {0, UINT16_MAX, true, false};
  if (is_unsigned) return {0, INT32_MAX, false, false};
  return {};
}

// Searches for a use of a variable that would give another result if the variable were an int.
class IntSearch {
 public:
  using Folder = std::function<std::optional<Constant>(const Expression&)>;

  /// The references must outlive the search; `variable` may be nullptr, to check values only.
  IntSearch(const Declarator* variable, Range range, const NameScopes& scopes, Folder fold)
      : variable_(variable), range_(range), scopes_(scopes), fold_(std::move(fold)) {}

  void Add(const Statement& statement) {
    for (const Declarator& declarator : statement.declarators) {
      if (&declarator == variable_ && declarator.initialiser != nullptr) {
        CheckValue(*declarator.initialiser);
      }
    }
    ForEachWholeExpression(statement, [this](const Expression& whole) {
      ForEachExpression(whole, [this](const Expression& inner) { Check(inner); });
    });
  }

  /// The use found, or nullptr.
  const Expression* difference() const {
    if (uncertain_value_ == nullptr) return nullptr;
    return range_.narrow ? uncertain_value_ : sensitive_use_;
  }

  /// True if a value is the same in the variable and in an int.
  bool Fits(const Expression& value) const {
    if (const std::optional<Constant> constant = fold_(value)) {
      return !constant->is_double && constant->integer >= range_.minimum &&
             constant->integer <= range_.maximum;
    }
    switch (value.kind) {
      case Expression::Kind::kParen:
        return Fits(*value.operands[0]);
      case Expression::Kind::kConditional:
        return Fits(*value.operands[1]) && Fits(*value.operands[2]);
      case Expression::Kind::kName:
      case Expression::Kind::kIndex: {
        const VisibleName* name = scopes_.Find(BaseName(value), value.range);
        return name != nullptr && (name->declarator == variable_ || IsBool(*name->specifiers));
      }
      case Expression::Kind::kUnary:
        return value.op == "!";
      case Expression::Kind::kBinary:
        return IsTruth(*vm::FindBinaryOperator(value.op));
      default:
        return false;
    }
  }

 private:
  void CheckValue(const Expression& value) {
    if (value.kind == Expression::Kind::kBraces) {
      for (const ExpressionPtr& element : value.operands) CheckValue(*element);
    } else if (!Fits(value) && uncertain_value_ == nullptr) {
      uncertain_value_ = &value;
    }
  }
  void Check(const Expression& expression) {
    const bool assigns = IsAnyOf(expression.op, {"=", "++", "--", "&"}) ||
                         expression.kind == Expression::Kind::kCompound;
    if (assigns && !expression.operands.empty() && Means(*expression.operands[0])) {
      CheckWrite(expression);
    }
    // Operators for which a sign or the 32nd bit matters.
    const bool sensitive = (expression.kind == Expression::Kind::kBinary ||
                            expression.kind == Expression::Kind::kCompound) &&
                           !IgnoresSign(expression.op);
    if (sensitive && sensitive_use_ == nullptr && Mentions(expression)) {
      sensitive_use_ = &expression;
    }
  }
  bool Means(const Expression& expression) const {
    const std::string_view name = BaseName(expression);
    if (name.empty() || name != variable_->name) return false;
    const VisibleName* visible = scopes_.Find(name, expression.range);
    return visible != nullptr && visible->declarator == variable_;
  }
  bool Mentions(const Expression& expression) const {
    bool found = false;
    ForEachExpression(expression, [this, &found](const Expression& inner) {
      found = found || (inner.kind == Expression::Kind::kName && Means(inner));
    });
    return found;
  }
  void CheckWrite(const Expression& expression) {
    if (expression.kind == Expression::Kind::kBinary) return;  // `a & b`
    const bool never_negative =
        !range_.narrow &&
        (expression.op == "++" || (IsAnyOf(expression.op, {"+=", "&=", "/=", "%=", ">>="}) &&
                                   Fits(*expression.operands[1])));
    // An operand within the range has no bits outside the range.
    const bool stays = !range_.is_signed && IsAnyOf(expression.op, {"&=", "|=", "^="}) &&
                       Fits(*expression.operands[1]);
    if (never_negative || stays) return;
    if (expression.kind == Expression::Kind::kAssign) {
      CheckValue(*expression.operands[1]);
    } else if (uncertain_value_ == nullptr) {
      uncertain_value_ = &expression;
    }
  }

  const Declarator* variable_;
  Range range_;
  const NameScopes& scopes_;
  Folder fold_;
  const Expression* uncertain_value_ = nullptr;
  const Expression* sensitive_use_ = nullptr;
};

// Why a declaration cannot be replaced by one of an int.
Message DescribeDifference(const Specifiers& specifiers) {
  if (IsBool(specifiers)) {
    return MakeMessage(
        "a bool stores every value other than 0 as 1, an int keeps it; write '!= 0' here, then "
        "'int'",
        "bool 把 0 以外的值都变成 1，int 保留原值；请在此写上 '!= 0'，再改为 int");
  }
  return MakeMessage(
      "an int is signed and has 32 bits, so this can give a different result; if it cannot, write "
      "'int' yourself",
      "int 有符号且为 32 位，此处的结果可能因此不同；如果不会，请自行改为 int");
}

bool IsZero(const Expression& value, const std::function<bool(const Expression&)>& is_zero) {
  if (value.kind != Expression::Kind::kBraces) return is_zero(value);
  return std::all_of(value.operands.begin(), value.operands.end(),
                     [&is_zero](const ExpressionPtr& item) { return IsZero(*item, is_zero); });
}

}  // namespace

const std::vector<StatementPtr>& Declarations::ScopeOfNames() const {
  return context_.function != nullptr ? context_.function->syntax->body : context_.tree->items;
}

NameUses Declarations::UsesHere(std::string_view name) {
  if (context_.function != nullptr) return context_.UsesInFunction(name);
  if (!program_uses_) program_uses_.emplace().Add(context_.tree->items);
  return program_uses_->Find(name);
}

// True if an int gives the same results as a variable of the foreign type, as far as can be
// determined.
bool Declarations::KeepsMeaning(const Specifiers& specifiers, const DeclaredType& type,
                                std::span<const Declarator> declarators) {
  if (type.type == DataType::kDouble || type.is_void || type.structure != nullptr) return true;
  const auto longs = std::count_if(specifiers.words.begin(), specifiers.words.end(),
                                   [](const Token* word) { return word->text == "long"; });
  if (longs > 1) {
    AddNote(*type.report, MakeMessage("an int has 32 bits; if that is enough, write 'int' yourself",
                                      "int 只有 32 位；如果足够，请自行改为 int"));
    return false;
  }
  const Range range = RangeOf(specifiers);
  if (range.is_signed && !range.narrow) return true;
  for (const Declarator& declarator : declarators) {
    IntSearch search(&declarator, range, Scopes(),
                     [this](const Expression& value) { return context_.FoldHere(value); });
    for (const StatementPtr& item : ScopeOfNames()) {
      ForEachStatement(*item, [&search](const Statement& below) { search.Add(below); });
    }
    const Expression* difference = search.difference();
    if (difference == nullptr) continue;
    AddNote(*type.report, difference->range, DescribeDifference(specifiers));
    return false;
  }
  return true;
}

// True if the values that a function of the foreign type returns are the same as ints.
bool Declarations::KeepsReturns(const Function& function, const DeclaredType& type) {
  const Range range = RangeOf(function.specifiers);
  if (type.report == nullptr || !range.narrow) return true;
  const IntSearch search(nullptr, range, Scopes(),
                         [this](const Expression& value) { return context_.FoldHere(value); });
  const Expression* difference = nullptr;
  for (const StatementPtr& item : function.body) {
    ForEachStatement(*item, [&](const Statement& below) {
      if (below.kind != Statement::Kind::kReturn || below.value == nullptr) return;
      if (difference == nullptr && !search.Fits(*below.value)) difference = below.value.get();
    });
  }
  if (difference == nullptr) return true;
  AddNote(*type.report, difference->range, DescribeDifference(function.specifiers));
  return false;
}

const NameScopes& Declarations::Scopes() {
  if (!scopes_) scopes_.emplace(*context_.tree);
  return *scopes_;
}

// A global const with a number becomes a macro, any other const a variable.
bool Declarations::CorrectConst(const DeclaredType& type, std::span<const Declarator> declarators,
                                SourceRange declaration, bool* as_macros) {
  std::string macros;
  bool numbers = !declarators.empty();
  for (const Declarator& declarator : declarators) {
    if (const Expression* write = UsesHere(declarator.name).first_write) {
      AddNote(*type.report, write->range,
              MakeMessage("'{0}' is changed here; remove this statement, or 'const'",
                          "'{0}' 在此处被修改；请去掉该语句，或去掉 const", declarator.name));
      return false;
    }
    if (type.is_parameter) return true;
    if (declarator.initialiser == nullptr) {
      AddNote(*type.report,
              MakeMessage("'{0}' has no value and can never get one; write it here",
                          "'{0}' 没有值，以后也无法赋值；请在此写出", declarator.name));
      return false;
    }
    std::optional<Constant> value = context_.FoldHere(*declarator.initialiser);
    if (!value || !declarator.sizes.empty() || declarator.pointer) {
      numbers = false;
      continue;
    }
    if (value->is_double && type.type == DataType::kInt) {
      value->integer = static_cast<int64_t>(value->real);
    }
    value->real = value->AsDouble();
    value->is_double = type.type == DataType::kDouble;
    macros +=
        fmt::format("{}#define {} {}", macros.empty() ? "" : "\n", declarator.name, value->Text());
  }
  if (context_.function != nullptr) return true;
  if (!numbers) {
    AddNote(*type.report,
            MakeMessage("globals have no initial values; write numbers as #define, and fill arrays "
                        "in a function or from the host",
                        "全局变量没有初值；数值请写成 #define，数组请在函数中或由主机赋值"));
    return false;
  }
  // A directive must be on a line of its own.
  const std::string_view text = context_.files[static_cast<size_t>(declaration.file)].text();
  const size_t line_begin = text.rfind('\n', declaration.begin) + 1;
  const std::string_view before = text.substr(line_begin, declaration.begin - line_begin);
  const size_t next = text.find_first_not_of(" \t\r", declaration.end);
  const bool alone_before = before.find_first_not_of(" \t") == std::string_view::npos;
  const bool alone_behind = next == std::string_view::npos || text[next] == '\n';
  Replace(*type.report, declaration,
          fmt::format("{}{}{}", alone_before ? "" : "\n", macros, alone_behind ? "" : "\n"));
  *as_macros = true;
  return true;
}

// Offers the language's own types in place of foreign ones. True if the declaration becomes #define
// lines, which include the values.
bool Declarations::CorrectType(const Specifiers& specifiers, const DeclaredType& type,
                               std::span<const Declarator> declarators, SourceRange declaration) {
  if (type.report == nullptr || !type.valid) return false;
  if (type.is_static && context_.function != nullptr) {
    AddNote(*type.report, MakeMessage("a variable that keeps its value between runs of a function "
                                      "is a global; declare it before the function",
                                      "函数各次运行共用的变量是全局变量；请在函数之前声明"));
    return false;
  }
  if (!KeepsMeaning(specifiers, type, declarators)) return false;
  bool as_macros = false;
  if (type.is_const && !declarators.empty() &&
      !CorrectConst(type, declarators, declaration, &as_macros)) {
    return false;
  }
  if (!as_macros) Replace(*type.report, specifiers.range, type.plain);
  return as_macros;
}

// Variables start at 0, so only that value can be omitted.
void Declarations::CorrectGlobalInitialiser(const Declarator& declarator, Diagnostic& diagnostic,
                                            SourceRange value) {
  const bool zero = IsZero(*declarator.initialiser, [this](const Expression& element) {
    const std::optional<Constant> constant = context_.FoldHere(element);
    return constant && constant->AsDouble() == 0;
  });
  if (zero) {
    Replace(diagnostic, value, "");
    return;
  }
  AddNote(diagnostic,
          MakeMessage("assign it in a function, or set it from the host with GT_SetVarValue; a "
                      "number that never changes can be a #define",
                      "请在函数中赋值，或由主机用 GT_SetVarValue 设置；不变的数值可写成 #define"));
}

// Renames a name that shadows another one, in the whole block that declares it.
void Declarations::Rename(const Declarator& declarator, Diagnostic& diagnostic) {
  constexpr int kRoomForNumber = 4;
  const std::string_view old = declarator.name;
  const std::string fresh = context_.fresh.Make(
      old.substr(0, std::min<size_t>(old.size(), vm::kNameLengthMax - kRoomForNumber)));
  const uint32_t begin = declarator.name_range.begin;
  const auto rename = [&](const Statement& statement) {
    for (const Declarator& other : statement.declarators) {
      if (other.name == old && other.name_range.begin >= begin) {
        Replace(diagnostic, other.name_range, fresh);
      }
    }
    ForEachWholeExpression(statement, [&](const Expression& whole) {
      ForEachExpression(whole, [&](const Expression& inner) {
        if (inner.kind == Expression::Kind::kName && inner.text == old &&
            inner.range.begin >= begin) {
          Replace(diagnostic, inner.range, fresh);
        }
      });
    });
  };
  const Statement* block = context_.function->blocks.back().statement;
  if (block != nullptr) {
    ForEachStatement(*block, rename);
    return;
  }
  for (const StatementPtr& item : context_.function->syntax->body) ForEachStatement(*item, rename);
}

}  // namespace oncard::compiler
