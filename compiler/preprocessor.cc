#include "compiler/preprocessor.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/limits.h"
#include "compiler/condition.h"
#include "compiler/header_types.h"
#include "compiler/include_files.h"
#include "compiler/lexer.h"
#include "compiler/parser.hh"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;

constexpr int kIncludeDepthMax = 32;
// The arguments for `...`.
constexpr std::string_view kVariadicName = "__VA_ARGS__";

// Attributes, and words like them, that are about warnings, about how a program is compiled, or
// promises about it.
constexpr std::string_view kNoEffect[] = {"__extension__",
                                          "_Noreturn",
                                          "access",
                                          "always_inline",
                                          "artificial",
                                          "assume_aligned",
                                          "cdecl",
                                          "cold",
                                          "const",
                                          "deprecated",
                                          "externally_visible",
                                          "fallthrough",
                                          "flatten",
                                          "format",
                                          "format_arg",
                                          "gnu_inline",
                                          "hot",
                                          "leaf",
                                          "maybe_unused",
                                          "no_icf",
                                          "no_instrument_function",
                                          "no_reorder",
                                          "no_sanitize",
                                          "no_sanitize_address",
                                          "no_sanitize_undefined",
                                          "no_split_stack",
                                          "no_stack_protector",
                                          "noclone",
                                          "nodiscard",
                                          "noinline",
                                          "noipa",
                                          "nonnull",
                                          "noreturn",
                                          "nothrow",
                                          "optimize",
                                          "pure",
                                          "regparm",
                                          "restrict",
                                          "returns_nonnull",
                                          "sentinel",
                                          "stdcall",
                                          "unused",
                                          "used",
                                          "visibility",
                                          "warn_unused_result",
                                          "warning"};

// Also between two pairs of underlines, as in `__unused__`.
bool HasNoEffect(std::string_view word) {
  const bool known =
      std::find(std::begin(kNoEffect), std::end(kNoEffect), word) != std::end(kNoEffect);
  if (known || !word.starts_with("__")) return known;
  word.remove_prefix(2);
  if (word.ends_with("__")) word.remove_suffix(2);
  return HasNoEffect(word);
}

Token NumberToken(const Token& like, bool value) {
  Token token = like;
  token.kind = Kind::kInteger;
  token.literal = {};
  token.literal.magnitude = value ? 1 : 0;
  return token;
}

// Bodies are equal if their words are.
bool SameBody(const MacroDefinition& a, const MacroDefinition& b) {
  return a.has_parameters == b.has_parameters && a.is_variadic == b.is_variadic &&
         a.parameters == b.parameters &&
         std::equal(a.body.begin(), a.body.end(), b.body.begin(), b.body.end(),
                    [](const Token& x, const Token& y) { return x.text == y.text; });
}

bool BeginsBefore(const SourceRange& a, const SourceRange& b) {
  return std::tuple(a.file, a.begin) < std::tuple(b.file, b.begin);
}

}  // namespace

void Preprocessor::Run(SourceFile program) {
  AddFile(std::move(program), 0, 0);
  if (files_.refused()) tokens_.clear();
  DropReportsOfSkippedText();
  tokens_.push_back(files_.EndToken());
  RemoveAttributes();
}

// Removes `__attribute__((...))` and words that say nothing about what a program computes.
void Preprocessor::RemoveAttributes() {
  size_t kept = 0;
  bool new_line = false;
  for (size_t i = 0; i < tokens_.size(); ++i) {
    const size_t end = EndOfAttribute(i);
    if (end > i) {
      new_line |= tokens_[i].on_new_line;
      i = end - 1;
      continue;
    }
    Token token = tokens_[i];
    token.on_new_line |= std::exchange(new_line, false);
    tokens_[kept++] = token;
  }
  tokens_.resize(kept);
}

// The place behind the attribute that begins at a place, each word of which is reported; the place
// itself if there is none.
size_t Preprocessor::EndOfAttribute(size_t begin) {
  const Token& word = tokens_[begin];
  if (word.kind != Kind::kReserved) return begin;
  if (HasNoEffect(word.text)) {
    IgnoreAttribute(word);
    return begin + 1;
  }
  const auto kind_at = [this](size_t i) {
    return i < tokens_.size() ? tokens_[i].kind : static_cast<int>(Kind::kEnd);
  };
  const bool attribute = word.text.starts_with("__attribute") &&
                         kind_at(begin + 1) == Kind::kOpenParen &&
                         kind_at(begin + 2) == Kind::kOpenParen;
  if (!attribute) return begin;
  size_t end = begin + 1;
  for (int depth = 0; end < tokens_.size(); ++end) {
    if (tokens_[end].kind == Kind::kOpenParen) ++depth;
    if (tokens_[end].kind == Kind::kCloseParen && --depth == 0) break;
  }
  if (end == tokens_.size() || tokens_[end - 1].kind != Kind::kCloseParen) return begin;
  int depth = 0;
  for (size_t i = begin + 1; i < end; ++i) {
    const bool first = depth == 2 && (tokens_[i - 1].kind == Kind::kOpenParen ||
                                      tokens_[i - 1].kind == Kind::kComma);
    if (tokens_[i].kind == Kind::kOpenParen) ++depth;
    if (tokens_[i].kind == Kind::kCloseParen) --depth;
    if (!first || !IsWord(tokens_[i])) continue;
    if (HasNoEffect(tokens_[i].text)) {
      IgnoreAttribute(tokens_[i]);
    } else {
      reporter_.Report(Code::kNotForTheCard, tokens_[i].range, tokens_[i].text,
                       MakeMessage("an attribute that changes what the program does; leave it out "
                                   "if it is not needed",
                                   "该属性会改变程序的行为；如果不需要，请去掉它"));
    }
  }
  return end + 1;
}

// A remark about each of them once.
void Preprocessor::IgnoreAttribute(const Token& word) {
  if (!ignored_.insert(word.text).second) return;
  reporter_.Report(Code::kIgnoredAttribute, word.range, word.text);
}

void Preprocessor::AddFile(SourceFile file, uint32_t inclusion_point, int depth) {
  const int index = files_.count();
  const std::optional<std::vector<Token>> scanned = files_.Add(std::move(file), inclusion_point);
  if (!scanned) return;
  const std::vector<Token>& tokens = *scanned;
  const std::string_view text = files_.TextOf(index);
  AppendComments(text, index, tokens, &comments_);
  const size_t open = conditionals_.size();
  const std::span<const Token> all(tokens);
  uint32_t text_begin = 0;
  for (size_t i = 0; i < tokens.size() && !files_.refused();) {
    // The text up to the next directive, and that directive.
    size_t end = i;
    while (end < tokens.size() && !(tokens[end].kind == Kind::kHash && tokens[end].on_new_line)) {
      ++end;
    }
    size_t after = std::min(end + 1, tokens.size());
    while (after < tokens.size() && !tokens[after].on_new_line) ++after;
    const uint32_t text_end =
        end < tokens.size() ? tokens[end].range.begin : static_cast<uint32_t>(text.size());
    if (Reading()) {
      AddText(all.subspan(i, end - i));
    } else {
      skipped_.push_back({index, text_begin, text_end});
    }
    if (end < tokens.size()) {
      Directive(all.subspan(end, after - end), depth);
      // Reports about the end of the directive stand before the text.
      text_begin = tokens[after - 1].range.end + 1;
    }
    i = after;
  }
  for (; conditionals_.size() > open; conditionals_.pop_back()) {
    reporter_.Report(Code::kUnbalancedIf, conditionals_.back().place, std::string_view("if"),
                     MakeMessage("is not closed with #endif", "没有对应的 #endif"));
  }
}

void Preprocessor::AddText(std::span<const Token> text) {
  std::vector<Token> expanded;
  if (!macros_.Expand(text, &expanded)) {
    files_.Refuse(MakeMessage("expanding its macros takes more than {0} tokens",
                              "展开宏需要的记号超过 {0} 个", kTokenMax));
    return;
  }
  for (const Token& token : expanded) Emit(token);
}

// What the parser gets: only now a word is known not to be a macro, and a number not to be one of
// the 64 bits that conditions have.
void Preprocessor::Emit(Token token) {
  if (token.kind == Kind::kInteger && token.literal.invalid) {
    const std::optional<IntegerOfC> integer = ReadIntegerOfC(token.text);
    if (integer && integer->is_long_long) {
      reporter_.Report(Code::kLongLong, token.range, token.text);
    }
  }
  if (token.kind == Kind::kName && (token.text == "true" || token.text == "false")) {
    token = NumberToken(token, token.text == "true");
  }
  tokens_.push_back(token);
}

void Preprocessor::Directive(Line line, int depth) {
  const SourceRange whole = {line.front().range.file, line.front().range.begin,
                             line.back().range.end};
  if (line.size() == 1) return;  // `#` alone says nothing
  const std::string_view word = IsWord(line[1]) ? line[1].text : std::string_view();
  if (ConditionalDirective(line, whole, word)) return;
  if (!Reading()) {
    skipped_.push_back(whole);
    return;
  }
  const std::string_view text = files_.TextOf(whole.file);
  if (word == "define") {
    Define(line, whole);
  } else if (word == "undef") {
    const Token* name = nullptr;
    if (NameAfter(line, whole, &name)) macros_.Undefine(name->text);
  } else if (word == "include") {
    Include(line, whole, depth);
  } else if (word == "error") {
    skipped_.push_back(whole);
    const uint32_t begin = line.size() > 2 ? line[2].range.begin : whole.end;
    const std::string_view reason = text.substr(begin, whole.end - begin);
    // The text of the directive is no program.
    DropReportsOfSkippedText();
    skipped_.clear();
    reporter_.Report(Code::kErrorDirective, whole, reason);
  } else if (word == "pragma") {
    skipped_.push_back(whole);
    if (line.size() > 2 && line[2].text == "once") {
      once_.insert(files_.PathOf(whole.file));
    }
  } else {
    reporter_.Report(Code::kUnknownDirective, whole,
                     word.empty() ? std::string_view(line[1].text) : word);
  }
}

// #if and its relatives. False for any other directive.
bool Preprocessor::ConditionalDirective(Line line, SourceRange whole, std::string_view word) {
  if (word == "if" || word == "ifdef" || word == "ifndef") {
    Conditional conditional;
    conditional.place = whole;
    conditional.around = Reading();
    conditional.reading = false;
    if (!conditional.around) {
      skipped_.push_back(whole);
    } else if (const std::optional<bool> holds = Condition(line, whole, word)) {
      conditional.reading = conditional.taken = *holds;
    } else {
      conditional.taken = true;  // neither branch, after an error
    }
    conditionals_.push_back(conditional);
    return true;
  }
  if (word != "elif" && word != "else" && word != "endif") return false;
  const bool here = !conditionals_.empty() && conditionals_.back().place.file == whole.file;
  if (!here) {
    reporter_.Report(Code::kUnbalancedIf, whole, word,
                     MakeMessage("has no #if before it", "之前没有 #if"));
  } else if (word == "endif") {
    conditionals_.pop_back();
  } else {
    NextBranch(line, whole, word);
  }
  return true;
}

void Preprocessor::NextBranch(Line line, SourceRange whole, std::string_view word) {
  Conditional& conditional = conditionals_.back();
  if (conditional.last) {
    AddNote(reporter_.Report(Code::kUnbalancedIf, whole, word,
                             MakeMessage("stands after #else", "位于 #else 之后")),
            conditional.place, MakeMessage("the #if is here", "#if 在此处"));
    return;
  }
  conditional.last = word == "else";
  const bool open = conditional.around && !conditional.taken;
  conditional.reading = false;
  if (!open) {
    skipped_.push_back(whole);
    return;
  }
  std::optional<bool> holds = true;
  if (word == "elif") holds = Condition(line, whole, word);
  conditional.reading = holds.value_or(false);
  conditional.taken = holds.value_or(true);
}

// The condition of #if, #ifdef, #ifndef or #elif; empty after a report.
std::optional<bool> Preprocessor::Condition(Line line, SourceRange whole, std::string_view word) {
  if (word == "ifdef" || word == "ifndef") {
    const Token* name = nullptr;
    if (!NameAfter(line, whole, &name)) return std::nullopt;
    return (macros_.Find(name->text) != nullptr) == (word == "ifdef");
  }
  std::vector<Token> condition;
  for (size_t i = 2; i < line.size(); ++i) {
    if (line[i].text != "defined") {
      condition.push_back(line[i]);
      continue;
    }
    const bool parens = i + 1 < line.size() && line[i + 1].kind == Kind::kOpenParen;
    const size_t name = i + (parens ? 2 : 1);
    const bool good =
        name < line.size() && IsWord(line[name]) &&
        (!parens || (name + 1 < line.size() && line[name + 1].kind == Kind::kCloseParen));
    if (!good) {
      condition.clear();
      break;
    }
    condition.push_back(NumberToken(line[i], macros_.Find(line[name].text) != nullptr));
    i = parens ? name + 1 : name;
  }
  std::vector<Token> expanded;
  std::optional<bool> holds;
  if (macros_.Expand(condition, &expanded)) holds = EvaluateCondition(expanded);
  if (!holds) {
    SourceRange range = whole;
    if (line.size() > 2) range.begin = line[2].range.begin;
    const std::string_view text = files_.TextOf(whole.file);
    reporter_.Report(
        Code::kBadCondition, range,
        line.size() > 2
            ? ToMessage(fmt::format("'{}'", text.substr(range.begin, range.end - range.begin)))
            : MakeMessage("the end of the line", "行尾"),
        word);
  }
  return holds;
}

// The name of #define, #undef, #ifdef and #ifndef. False, with a report, if there is none.
bool Preprocessor::NameAfter(Line line, SourceRange whole, const Token** name) {
  if (line.size() > 2 && IsWord(line[2]) && line[2].text != "defined") {
    *name = &line[2];
    return true;
  }
  if (line.size() > 2) {
    reporter_.Report(Code::kExpectedName, line[2].range, DescribeToken(line[2]));
  } else {
    reporter_.Report(Code::kExpectedName, SourceRange{whole.file, whole.end, whole.end},
                     MakeMessage("the end of the line", "行尾"));
  }
  return false;
}

void Preprocessor::Define(Line line, SourceRange whole) {
  const Token* name = nullptr;
  if (!NameAfter(line, whole, &name)) return;
  MacroDefinition macro;
  macro.name = name->text;
  macro.name_range = name->range;
  size_t next = 3;
  if (next < line.size() && line[next].kind == Kind::kOpenParen &&
      line[next].range.begin == name->range.end) {
    macro.has_parameters = true;
    if (!ReadParameters(line, &next, &macro)) return;
  }
  if (!ReadBody(line.subspan(std::min(next, line.size())), &macro)) return;
  const MacroDefinition* const earlier = macros_.Find(macro.name);
  if (earlier != nullptr && !SameBody(*earlier, macro)) {
    AddNote(reporter_.Report(Code::kRedefinition, macro.name_range, macro.name),
            earlier->name_range,
            MakeMessage("it is defined here; #undef ends that definition",
                        "已在此处定义；用 #undef 可以取消该定义"));
    return;
  }
  if (earlier == nullptr) macros_.Define(std::move(macro));
}

// Reads the body of a macro. False, with a report, if `#` or `##` have no operand in it.
bool Preprocessor::ReadBody(Line words, MacroDefinition* macro) {
  for (size_t i = 0; i < words.size(); ++i) {
    Token token = words[i];
    const bool joins = token.kind == Kind::kHash && i + 1 < words.size() &&
                       words[i + 1].kind == Kind::kHash &&
                       words[i + 1].range.begin == token.range.end;
    if (joins) {
      token.range.end = words[++i].range.end;
      token.text = "##";
    }
    macro->body.push_back(token);
  }
  const std::vector<Token>& body = macro->body;
  for (size_t i = 0; i < body.size(); ++i) {
    if (body[i].kind != Kind::kHash) continue;
    const auto& names = macro->parameters;
    if (IsJoining(body[i])) {
      if (i > 0 && i + 1 < body.size()) continue;
      reporter_.Report(
          Code::kMacroOperator, body[i].range, body[i].text,
          MakeMessage("has no word on one side; it joins two", "有一侧没有单词；它连接两个单词"));
      return false;
    }
    const bool parameter = i + 1 < body.size() &&
                           std::find(names.begin(), names.end(), body[i + 1].text) != names.end();
    if (parameter || !macro->has_parameters) continue;
    reporter_.Report(
        Code::kMacroOperator, body[i].range, body[i].text,
        MakeMessage("stands before the name of a parameter only", "只能位于参数的名称之前"));
    return false;
  }
  return true;
}

// Reads `(a, b)`; `next` becomes the place after it.
bool Preprocessor::ReadParameters(Line line, size_t* next, MacroDefinition* macro) {
  size_t at = *next + 1;
  std::unordered_set<std::string_view> known;
  const auto kind_at = [&line](size_t i) {
    return i < line.size() ? line[i].kind : static_cast<int>(Kind::kEnd);
  };
  bool wants_name = kind_at(at) != Kind::kCloseParen;
  for (;; ++at) {
    if (!wants_name && kind_at(at) == Kind::kCloseParen) break;
    if (!wants_name && kind_at(at) == Kind::kComma) {
      wants_name = true;
      continue;
    }
    // `...`, or `rest...` as some compilers have it, is the last one.
    if (kind_at(at) == Kind::kEllipsis && !macro->is_variadic && (wants_name || !known.empty()) &&
        kind_at(at + 1) == Kind::kCloseParen) {
      macro->is_variadic = true;
      if (wants_name) macro->parameters.push_back(kVariadicName);
      wants_name = false;
      continue;
    }
    const bool name = wants_name && at < line.size() && IsWord(line[at]);
    if (!name) {
      SourceRange range = line.back().range;
      Message found = MakeMessage("the end of the line", "行尾");
      if (at < line.size()) {
        range = line[at].range;
        found = DescribeToken(line[at]);
      }
      reporter_.Report(Code::kUnexpected, range, found,
                       wants_name ? MakeMessage("the name of a parameter", "参数的名称")
                                  : ToMessage(std::string_view("')'")));
      return false;
    }
    const std::string_view text = line[at].text;
    if (!known.insert(text).second) {
      reporter_.Report(Code::kRedefinition, line[at].range, text);
      return false;
    }
    macro->parameters.push_back(text);
    wants_name = false;
  }
  *next = at + 1;
  return true;
}

// Defines the macros of a header whose name has this range.
void Preprocessor::DefineKnown(std::string_view text, SourceRange range) {
  skipped_.push_back(range);
  if (text.empty()) return;
  // Tokens point into its text, which no file of the program holds.
  const SourceFile& file = made_.emplace_back(std::string(), std::string(text));
  std::vector<Token> tokens =
      Tokenize(file, range.file, kTokenMax, *options_.catalogue, reporter_, Dialect::kStructured);
  const Line all(tokens);
  for (size_t begin = 0, end = 1; begin < tokens.size(); begin = end++) {
    while (end < tokens.size() && !tokens[end].on_new_line) ++end;
    MacroDefinition macro;
    macro.name = tokens[begin + 2].text;
    macro.name_range = range;
    const Line body = all.subspan(begin + 3, end - begin - 3);
    macro.body.assign(body.begin(), body.end());
    if (macros_.Find(macro.name) == nullptr) macros_.Define(std::move(macro));
  }
}

void Preprocessor::Include(Line line, SourceRange whole, int depth) {
  SourceRange range = whole;
  if (line.size() > 2) range.begin = line[2].range.begin;
  std::string_view name = files_.TextOf(whole.file);
  name = name.substr(range.begin, range.end - range.begin);
  const bool quotes = line.size() == 3 && name.size() > 2 && name.front() == '"';
  const bool angles = line.size() > 3 && name.size() > 2 && name.front() == '<';
  const bool closed = (quotes && name.back() == '"') || (angles && name.back() == '>');
  if (quotes && !closed) return;  // the lexer has reported it
  if (!closed) {
    reporter_.Report(Code::kBadFileName, range,
                     line.size() > 2 ? ToMessage(fmt::format("'{}'", name))
                                     : MakeMessage("the end of the line", "行尾"));
    return;
  }
  const std::string file_name(name.substr(1, name.size() - 2));
  const std::string_view last_part =
      std::string_view(file_name).substr(file_name.find_last_of("/\\") + 1);
  const std::optional<std::string_view> known = TextOfKnownHeader(last_part);
  if (known && (angles || known->empty())) {
    DefineKnown(*known, range);
    return;
  }
  if (angles) {
    Diagnostic& diagnostic =
        reporter_.Report(Code::kBadFileName, range, ToMessage(fmt::format("'{}'", name)));
    if (IsHeaderOfC(file_name)) {
      AddNote(diagnostic, MakeMessage("programs have no C library, and abs and fabs need none; "
                                      "remove this line",
                                      "运动程序没有 C 语言的库，abs 和 fabs 不需要它；请去掉"));
      Replace(diagnostic, whole, "");
    }
    return;
  }
  if (whole.file == 0) program_include_ = whole;
  if (depth == kIncludeDepthMax) {
    AddNote(reporter_.Report(Code::kIncludeDepth, program_include_, int64_t{kIncludeDepthMax}),
            whole,
            MakeMessage("the last of these files is included here", "最后一个文件在此处被包含"));
    files_.Stop();  // files that include themselves twice would be read millions of times
    return;
  }
  const std::string& includer = files_.PathOf(whole.file);
  std::vector<std::string> beside = {includer};
  if (whole.file != 0) beside.push_back(files_.PathOf(0));
  IncludedFile file = FindInclude(file_name, beside, options_, reader_);
  if (!file.found && known && !file.unreadable) {
    DefineKnown(*known, range);
    return;
  }
  if (!file.found) {
    ReportMissingInclude(file_name, range, file, options_, reporter_);
    return;
  }
  if (once_.contains(file.path)) return;
  AddFile(SourceFile(std::move(file.path), std::move(file.text)), program_include_.begin,
          depth + 1);
}

// The lexer has looked at text that is not read, where anything may stand.
void Preprocessor::DropReportsOfSkippedText() {
  std::sort(skipped_.begin(), skipped_.end(), BeginsBefore);
  std::erase_if(reporter_.diagnostics(),
                [this](const Diagnostic& diagnostic) { return IsSkipped(diagnostic.range); });
}

bool Preprocessor::IsSkipped(const SourceRange& place) const {
  const auto after = std::upper_bound(skipped_.begin(), skipped_.end(), place, BeginsBefore);
  if (after == skipped_.begin()) return false;
  const SourceRange& candidate = *(after - 1);
  return candidate.file == place.file && place.begin < candidate.end;
}

}  // namespace oncard::compiler
