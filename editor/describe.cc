#include "editor/describe.h"

#include <fmt/core.h>

#include <algorithm>

#include "compiler/macro_body.h"
#include "compiler/parser.hh"
#include "editor/command_help.h"
#include "vm/fixed_point.h"
#include "vm/symbol_names.h"

namespace oncard::editor {
namespace {

using compiler::Token;
using Kind = compiler::Parser::token;

// A call is not searched further back than this.
constexpr size_t kCallTokensMax = 4096;

std::string CodeBlock(const std::string& code) { return fmt::format("```c\n{}\n```\n", code); }

Message KindText(const Analysis& analysis, const Symbol& symbol) {
  switch (symbol.kind) {
    case Symbol::Kind::kFunction:
      return IsThreadFunction(analysis.text, symbol)
                 ? MakeMessage("thread function", "线程函数")
                 : MakeMessage("function that others call", "被其他函数调用的函数");
    case Symbol::Kind::kGlobal:
      return MakeMessage("global variable, shared by all threads", "全局变量，所有线程共享");
    case Symbol::Kind::kLocal:
      return MakeMessage("local variable", "局部变量");
    case Symbol::Kind::kParameter:
      return MakeMessage("parameter", "参数");
    case Symbol::Kind::kLabel:
      return MakeMessage("label", "标号");
    case Symbol::Kind::kMacro:
      return MakeMessage("macro", "宏");
    case Symbol::Kind::kMacroParameter:
      return MakeMessage("parameter of a macro", "宏的参数");
    case Symbol::Kind::kConstant:
      return MakeMessage("constant of an enum", "枚举常量");
    case Symbol::Kind::kEnumeration:
      return MakeMessage("enum", "枚举");
    case Symbol::Kind::kStructure:
      return MakeMessage("structure", "结构");
    case Symbol::Kind::kType:
      return MakeMessage("name of a type", "类型名称");
    case Symbol::Kind::kMember:
      return MakeMessage("member of a structure", "结构的成员");
    case Symbol::Kind::kCommand:
      break;
  }
  return MakeMessage("command", "指令");
}

// The value of a number as the language reads it.
std::optional<std::string> ValueOf(const compiler::Literal& literal) {
  if (literal.invalid) return std::nullopt;
  if (const auto whole = compiler::IntValue(literal)) return fmt::format("{}", *whole);
  if (const auto raw = compiler::FixedValue(literal, vm::DoubleFormat::k32_16)) {
    return fmt::format("{}", static_cast<double>(*raw) / (1 << vm::kFractionBits));
  }
  return std::nullopt;
}

Json DescribeLiteral(const Analysis& analysis, const Token& token, Language language) {
  const auto value = ValueOf(token.literal);
  if (!value) return nullptr;
  Json json = {{"kind", "number"}, {"value", *value}};
  std::string text;
  if (const auto whole = compiler::IntValue(token.literal)) {
    json["hex"] = fmt::format("0x{:08X}", static_cast<uint32_t>(*whole));
    text = MakeMessage("int {0} = {1}", "int {0} = {1}", *whole, json["hex"].get<std::string>())
               .In(language);
  } else {
    const int64_t raw = compiler::FixedValue(token.literal, vm::DoubleFormat::k32_16).value_or(0);
    json["raw"] = raw;
    text = MakeMessage("fixed point: {0} / 65536 = {1}", "定点数：{0} / 65536 = {1}", raw, *value)
               .In(language);
  }
  json["markdown"] = text + "\n";
  json["range"] = RangeJson(analysis.text, token.range);
  return json;
}

// The value of a macro or constant that is a number.
std::optional<std::string> ConstantValue(const Analysis& analysis, const Symbol& symbol) {
  if (symbol.has_parameters) return std::nullopt;
  const auto lookup = [&](std::string_view name) -> std::optional<compiler::Literal> {
    const int found = analysis.names.Find(name, 0, analysis.text.code().size());
    if (found < 0) return std::nullopt;
    const Symbol& other = analysis.names.symbol(found);
    const bool known =
        other.kind == Symbol::Kind::kMacro && other.value.size() == 1 &&
        (other.value[0].kind == Kind::kInteger || other.value[0].kind == Kind::kFixed);
    if (!known) return std::nullopt;
    return other.value[0].literal;
  };
  const auto number = compiler::FoldMacroBody(symbol.value, lookup);
  if (!number) return std::nullopt;
  return number->value.Text();
}

const Token* MemberAt(const Analysis& analysis, Cursor cursor, const gtcalls::Member** member) {
  const std::vector<Token>& tokens = analysis.text.file(cursor.file).tokens;
  size_t at = TokenAt(tokens, cursor.offset);
  if ((at == tokens.size() || tokens[at].kind != Kind::kName) && at > 0 &&
      tokens[at - 1].range.end == cursor.offset) {
    --at;
  }
  if (at >= tokens.size() || tokens[at].range.begin > cursor.offset) return nullptr;
  *member = CardMemberAt(analysis, cursor.file, at);
  return *member != nullptr ? &tokens[at] : nullptr;
}

// The bracket that a closing one belongs to; empty for another token.
std::optional<size_t> OpeningOf(const std::vector<Token>& tokens, size_t close) {
  int depth = 0;
  for (size_t at = close + 1; at-- > 0;) {
    const int kind = tokens[at].kind;
    if (kind == Kind::kSemicolon || kind == Kind::kOpenBrace || kind == Kind::kCloseBrace) break;
    if (kind == Kind::kCloseBracket || kind == Kind::kCloseParen) ++depth;
    if (kind == Kind::kOpenBracket || kind == Kind::kOpenParen) --depth;
    if (depth == 0) return at == close ? std::nullopt : std::optional(at);
  }
  return std::nullopt;
}

// The members of a structure or of a type that is one, as they are declared.
std::string MembersText(const Analysis& analysis, const Symbol& symbol) {
  const bool type = symbol.kind == Symbol::Kind::kStructure || symbol.kind == Symbol::Kind::kType;
  if (!type || symbol.members < 0) return {};
  std::string text = " {\n";
  for (const Symbol& member : analysis.names.symbols()) {
    if (member.kind == Symbol::Kind::kMember && member.scope == symbol.members) {
      text += fmt::format("  {};\n", Declaration(analysis, member));
    }
  }
  return text + "}";
}

Json DescribeSymbol(const Analysis& analysis, int index, const vm::Object* object,
                    Language language) {
  const Symbol& symbol = analysis.names.symbol(index);
  Json json = {{"kind", KindName(symbol.kind)},
               {"name", symbol.name},
               {"declaration", Declaration(analysis, symbol)}};
  if (symbol.kind == Symbol::Kind::kCommand) {
    json["brief"] = Brief(*symbol.command, language);
    json["callers"] = Callers(*symbol.command, language);
    json["number"] = symbol.command->number;
    json["source"] = symbol.command->source;
    json["parameters"] = Json::array();
    for (const gtcalls::Parameter& parameter : symbol.command->parameters) {
      json["parameters"].push_back(ParameterJson(*symbol.command, parameter, language));
    }
    json["markdown"] = CommandMarkdown(*symbol.command, language);
    return json;
  }
  const Message kind = KindText(analysis, symbol);
  std::string text =
      CodeBlock(Declaration(analysis, symbol) + MembersText(analysis, symbol)) + kind.In(language);
  if (symbol.function >= 0 && symbol.kind != Symbol::Kind::kMacro) {
    const std::string_view function = analysis.names.symbol(symbol.function).name;
    json["function"] = function;
    text += MakeMessage(" of `{0}`", "，属于 `{0}`", function).In(language);
  }
  if (!symbol.type.empty()) json["type"] = symbol.type;
  const auto slots = object != nullptr ? SlotsOf(analysis, *object) : std::map<int, int>();
  if (const auto slot = slots.find(index); slot != slots.end()) {
    json["slot"] = slot->second;
    text += MakeMessage("; slot {0}", "；槽 {0}", slot->second).In(language);
  }
  if (symbol.kind == Symbol::Kind::kFunction) {
    json["thread_function"] = IsThreadFunction(analysis.text, symbol);
  }
  const bool has_value = symbol.kind == Symbol::Kind::kMacro ||
                         symbol.kind == Symbol::Kind::kConstant || symbol.is_const;
  if (has_value && !symbol.value.empty()) {
    if (const auto value = ConstantValue(analysis, symbol)) {
      json["value"] = *value;
      text += MakeMessage("; value {0}", "；值 {0}", *value).In(language);
    }
  }
  json["markdown"] = text + "\n";
  return json;
}

}  // namespace

bool IsThreadFunction(const ProgramText& text, const Symbol& function) {
  if (!text.structured()) return true;
  return !function.called && function.type.find("static") == std::string_view::npos;
}

const Symbol* OperandBefore(const Analysis& analysis, int file, size_t dot) {
  const std::vector<Token>& tokens = analysis.text.file(file).tokens;
  for (size_t at = std::min(dot, tokens.size()); at-- > 0;) {
    if (tokens[at].kind == Kind::kName) {
      const Reference* const found = analysis.names.At(file, tokens[at].range.begin);
      return found == nullptr ? nullptr : &analysis.names.symbol(found->symbol);
    }
    const std::optional<size_t> open = OpeningOf(tokens, at);
    if (!open) return nullptr;
    // What is in parentheses is meant, as in `(*p).x`, unless they belong to a call.
    const bool inside = tokens[at].kind == Kind::kCloseParen &&
                        (*open == 0 || tokens[*open - 1].kind != Kind::kName);
    if (!inside) at = *open;
  }
  return nullptr;
}

const gtcalls::Member* CardMemberAt(const Analysis& analysis, int file, size_t name) {
  const std::vector<Token>& tokens = analysis.text.file(file).tokens;
  const bool is_member =
      name >= 2 && tokens[name].kind == Kind::kName && tokens[name - 1].kind == Kind::kDot;
  if (!is_member) return nullptr;
  const Symbol* const operand = OperandBefore(analysis, file, name - 1);
  if (operand == nullptr || operand->structure == nullptr) return nullptr;
  const auto& members = operand->structure->members;
  const auto found = std::ranges::find(members, tokens[name].text, &gtcalls::Member::name);
  return found != members.end() ? &*found : nullptr;
}

std::map<int, int> SlotsOf(const Analysis& analysis, const vm::Object& object) {
  using Key = std::pair<std::string_view, std::string_view>;  // function, if any, and variable
  std::map<Key, int> known;
  const auto add = [&known](std::string_view function, const std::vector<vm::Symbol>& symbols) {
    for (const vm::Symbol& each : symbols) {
      // The members of a structure follow each other.
      known.try_emplace({function, vm::NameOfVariable(each)}, each.id);
    }
  };
  add({}, object.globals);
  for (const vm::Function& function : object.functions) add(function.name, function.variables);

  const std::deque<Symbol>& symbols = analysis.names.symbols();
  const auto key_of = [&](const Symbol& symbol) -> Key {
    return {symbol.function < 0 ? std::string_view() : analysis.names.symbol(symbol.function).name,
            symbol.name};
  };
  const auto is_variable = [](const Symbol& symbol) {
    return symbol.kind == Symbol::Kind::kGlobal || symbol.kind == Symbol::Kind::kLocal ||
           symbol.kind == Symbol::Kind::kParameter;
  };
  std::map<Key, int> count;
  for (const Symbol& symbol : symbols) {
    if (is_variable(symbol)) ++count[key_of(symbol)];
  }
  std::map<int, int> slots;
  for (size_t i = 0; i < symbols.size(); ++i) {
    if (!is_variable(symbols[i]) || count[key_of(symbols[i])] != 1) continue;
    const auto found = known.find(key_of(symbols[i]));
    if (found != known.end()) slots[static_cast<int>(i)] = found->second;
  }
  return slots;
}

Json Describe(const Analysis& analysis, Cursor cursor, const vm::Object* object,
              Language language) {
  if (InComment(analysis.text, cursor)) return nullptr;
  if (const Reference* reference = analysis.names.At(cursor.file, cursor.offset)) {
    Json json = DescribeSymbol(analysis, reference->symbol, object, language);
    json["range"] = RangeJson(analysis.text, reference->range);
    return json;
  }
  const gtcalls::Member* member = nullptr;
  if (const Token* token = MemberAt(analysis, cursor, &member)) {
    const std::string declaration =
        fmt::format("{} {}", gtcalls::SpellScalar(member->type), member->name);
    const std::string_view unit = gtcalls::SpellUnit(member->unit);
    return {{"kind", "member"},
            {"name", member->name},
            {"declaration", declaration},
            {"markdown", CodeBlock(unit.empty() ? declaration
                                                : fmt::format("{}  /* {} */", declaration, unit))},
            {"range", RangeJson(analysis.text, token->range)}};
  }
  const std::vector<Token>& tokens = analysis.text.file(cursor.file).tokens;
  const size_t at = TokenAt(tokens, cursor.offset);
  if (at < tokens.size() && tokens[at].range.begin <= cursor.offset &&
      (tokens[at].kind == Kind::kInteger || tokens[at].kind == Kind::kFixed)) {
    return DescribeLiteral(analysis, tokens[at], language);
  }
  return nullptr;
}

CallAt FindCall(const Analysis& analysis, Cursor cursor) {
  const std::vector<Token>& tokens = analysis.text.file(cursor.file).tokens;
  size_t at = static_cast<size_t>(
      std::ranges::lower_bound(tokens, cursor.offset, {},
                               [](const Token& token) { return token.range.begin; }) -
      tokens.begin());
  // A bracket that begins before the cursor is before it, one that begins at it is not.
  CallAt call;
  int closed = 0;
  const size_t lowest = at > kCallTokensMax ? at - kCallTokensMax : 0;
  while (at-- > lowest) {
    const int kind = tokens[at].kind;
    if (kind == Kind::kSemicolon || kind == Kind::kOpenBrace || kind == Kind::kCloseBrace) break;
    if (kind == Kind::kHash && tokens[at].on_new_line) break;
    if (kind == Kind::kCloseParen || kind == Kind::kCloseBracket) ++closed;
    if (kind == Kind::kComma && closed == 0) ++call.argument;
    if (kind != Kind::kOpenParen && kind != Kind::kOpenBracket) continue;
    if (closed-- > 0) continue;
    closed = 0;
    const Reference* callee =
        kind == Kind::kOpenParen && at > 0 && tokens[at - 1].kind == Kind::kName
            ? analysis.names.At(cursor.file, tokens[at - 1].range.begin)
            : nullptr;
    if (callee != nullptr) {
      const Symbol& symbol = analysis.names.symbol(callee->symbol);
      if (callee->access == Reference::Access::kDeclaration) break;
      if (symbol.has_parameters) {
        call.callee = &symbol;
        call.name = callee->range;
        return call;
      }
    }
    call.argument = 0;  // it was a comma inside other brackets
  }
  return {};
}

Json Signature(const Analysis& analysis, Cursor cursor, Language language) {
  if (InComment(analysis.text, cursor)) return nullptr;
  const CallAt call = FindCall(analysis, cursor);
  if (call.callee == nullptr) return nullptr;
  const Symbol& callee = *call.callee;
  Json parameters = Json::array();
  std::string label = Declaration(analysis, callee);
  if (callee.command != nullptr) {
    for (const gtcalls::Parameter& parameter : callee.command->parameters) {
      parameters.push_back(ParameterJson(*callee.command, parameter, language));
    }
  } else {
    for (const int index : callee.parameters) {
      const Symbol& parameter = analysis.names.symbol(index);
      parameters.push_back({{"name", parameter.name}, {"label", Declaration(analysis, parameter)}});
    }
    if (callee.kind == Symbol::Kind::kMacro) {
      label = fmt::format("{}(", callee.name);
      for (const Json& parameter : parameters) {
        if (!label.ends_with('(')) label += ", ";
        label += parameter["label"].get<std::string>();
      }
      label += ')';
    }
  }
  Json json = {{"kind", KindName(callee.kind)},
               {"name", callee.name},
               {"label", label},
               {"parameters", std::move(parameters)}};
  if (callee.command != nullptr) json["brief"] = Brief(*callee.command, language);
  const size_t count = json["parameters"].size();
  if (call.argument < count) json["active"] = call.argument;
  json["range"] = RangeJson(analysis.text, call.name);
  return json;
}

}  // namespace oncard::editor
