#include "compiler/directives.h"

#include <algorithm>

#include "compiler/include_files.h"
#include "compiler/lexer.h"
#include "compiler/macro_body.h"
#include "compiler/parser.hh"
#include "vm/limits.h"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;

bool IsNumber(const Token& token) {
  return token.kind == Kind::kInteger || token.kind == Kind::kFixed;
}

bool IsBool(std::string_view name) { return name == "bool" || name == "_Bool"; }

}  // namespace

void Directives::Run(SourceFile program) {
  AddFile(std::move(program), 0);
  if (files_.refused()) tokens_.clear();
  CorrectOpenMacros();
  tokens_.push_back(files_.EndToken());
}

void Directives::AddFile(SourceFile file, uint32_t inclusion_point) {
  const int index = files_.count();
  const std::optional<std::vector<Token>> scanned = files_.Add(std::move(file), inclusion_point);
  if (!scanned) return;
  const std::vector<Token>& tokens = *scanned;
  tokens_.reserve(tokens_.size() + tokens.size() + 1);
  bool external_begins = true;
  for (size_t i = 0; i < tokens.size();) {
    const Token& token = tokens[i];
    if (external_begins && open_braces_.empty()) external_ = token.range;
    if (token.kind == Kind::kHash && token.on_new_line) {
      std::vector<Token> line;
      do {
        line.push_back(tokens[i++]);
      } while (i < tokens.size() && !tokens[i].on_new_line);
      Directive(line);
      external_begins = true;
      continue;
    }
    if (token.kind == Kind::kOpenBrace) open_braces_.push_back(token.range);
    if (token.kind == Kind::kCloseBrace && !open_braces_.empty()) open_braces_.pop_back();
    external_begins = token.kind == Kind::kSemicolon || token.kind == Kind::kCloseBrace;
    // `bool` is not a keyword, so that variables can have this name; but if another name follows,
    // it is the type.
    const bool after_type = token.kind == Kind::kName || token.kind == Kind::kConst;
    if (after_type && !tokens_.empty() && tokens_.back().kind == Kind::kName &&
        IsBool(tokens_.back().text)) {
      tokens_.back().kind = Kind::kBool;
    }
    tokens_.push_back(token);
    ++i;
  }
  // A function cannot continue after the end of an included file.
  if (index == 0) return;
  const uint32_t size = static_cast<uint32_t>(files_.TextOf(index).size());
  if (!open_braces_.empty()) {
    Diagnostic& diagnostic = reporter_.Report(Code::kUnexpectedEnd, SourceRange{index, size, size},
                                              std::string_view("'}'"));
    AddNote(diagnostic, open_braces_.back(),
            MakeMessage("this '{{' is not closed", "此处的 '{{' 没有对应的 '}}'"));
  }
  for (; !open_braces_.empty(); open_braces_.pop_back()) {
    Token brace;
    brace.kind = Kind::kCloseBrace;
    brace.range = {index, size, size};
    tokens_.push_back(brace);
  }
}

void Directives::Directive(const std::vector<Token>& line) {
  const SourceRange whole = {line.front().range.file, line.front().range.begin,
                             line.back().range.end};
  const std::string_view word = line.size() > 1 && IsWord(line[1]) ? line[1].text : "";
  if (word != "define" && word != "include") {
    reporter_.Report(Code::kBadDirective, whole,
                     line.size() > 1 && word.empty() ? line[1].text : word);
    return;
  }
  if (!open_braces_.empty()) {
    Diagnostic& diagnostic = reporter_.Report(Code::kDirectiveInside, whole, word);
    const std::string_view text = files_.TextOf(whole.file);
    Replace(diagnostic, whole, "");
    if (external_.file == whole.file) {
      InsertBefore(diagnostic, external_,
                   std::string(text.substr(whole.begin, whole.end - whole.begin)) + "\n");
    }
    if (word == "include") return;
  }
  if (word == "define") {
    Define(line, whole);
  } else {
    Include(line, whole);
  }
}

void Directives::Define(const std::vector<Token>& line, SourceRange whole) {
  if (line.size() < 3 || line[2].kind != Kind::kName) {
    if (line.size() >= 3 && line[2].literal.invalid) return;  // the lexer has reported it
    SourceRange range = line.back().range;
    Message what = MakeMessage("the end of the line", "行尾");
    if (line.size() < 3) {
      range.begin = range.end;
    } else {
      range = line[2].range;
      what = DescribeToken(line[2]);
    }
    reporter_.Report(Code::kExpectedName, range, what);
    return;
  }
  const Token& name = line[2];
  Macro macro{name.text, name.range, {}};
  macro.value.invalid = true;

  for (size_t i = 3; i < line.size(); ++i) {
    if (line[i].kind == Kind::kName) names_in_bodies_.emplace(line[i].text, line[i].range);
  }

  // [ "(" ] [ "-" ] number-or-macro [ ")" ]
  size_t begin = 3;
  size_t end = line.size();
  const bool parameters = begin < end && line[begin].kind == Kind::kOpenParen &&
                          line[begin].range.begin == name.range.end;
  if (!parameters) {
    while (end - begin >= 2 && line[begin].kind == Kind::kOpenParen &&
           line[end - 1].kind == Kind::kCloseParen) {
      ++begin;
      --end;
    }
  }
  const bool negative = begin < end && line[begin].kind == Kind::kMinus;
  if (negative) ++begin;
  bool good = false;
  if (end == begin + 1 && IsNumber(line[begin])) {
    macro.value = line[begin].literal;
    good = true;
  } else if (end == begin + 1 && line[begin].kind == Kind::kName) {
    const auto earlier = macro_by_name_.find(line[begin].text);
    if (earlier != macro_by_name_.end()) {
      macro.value = macros_[earlier->second].value;
      good = true;
    }
  }
  if (negative) macro.value.negative = !macro.value.negative;
  if (!good) {
    const bool reported = std::any_of(
        line.begin(), line.end(), [](const Token& token) { return token.kind == Kind::kInvalid; });
    if (!reported) {
      ReportBody(line, whole, parameters, macro);
    }
  }
  if (macros_.size() == vm::kMacroMax) {
    // One report is enough: all that follow would exceed the limit too.
    if (!too_many_) {
      reporter_.Report(Code::kTooManyMacros, name.range, name.text, int64_t{vm::kMacroMax});
    }
    too_many_ = true;
    skipped_names_.insert(name.text);
    return;
  }
  macro_by_name_.emplace(name.text, macros_.size());
  Token token;
  token.kind = Kind::kMacroDefinition;
  token.range = whole;
  token.text = name.text;
  token.macro = static_cast<int>(macros_.size());
  token.on_new_line = true;
  macros_.push_back(macro);
  tokens_.push_back(token);
}

void Directives::ReportBody(std::span<const Token> line, SourceRange whole, bool parameters,
                            Macro& macro) {
  Message what = MakeMessage("empty", "空的");
  SourceRange range = macro.name_range;
  if (line.size() > 3) {
    range = {whole.file, line[3].range.begin, whole.end};
    const std::string_view text = files_.TextOf(whole.file);
    what = ToMessage(fmt::format("'{}'", text.substr(range.begin, range.end - range.begin)));
  }
  Diagnostic& diagnostic = reporter_.Report(Code::kMacroBody, range, macro.name, what);
  if (parameters) return;
  const auto number = FoldMacroBody(line.subspan(3), [this](std::string_view name) {
    const auto earlier = macro_by_name_.find(name);
    if (earlier == macro_by_name_.end()) return TruthValue(name);
    const Literal& value = macros_[earlier->second].value;
    return value.invalid ? std::nullopt : std::optional(value);
  });
  if (!number) return;
  if (!number->closed) {
    open_macros_.push_back({macro.name, &diagnostic, range, number->value});
    return;
  }
  Replace(diagnostic, range, number->value.Text());
  macro.value = number->value.AsLiteral();
}

// C replaces the name by the body: `2 * N` with `3 + 4` for N is 10. The value may replace the body
// only if each use is a whole expression.
void Directives::CorrectOpenMacros() {
  if (open_macros_.empty()) return;
  std::unordered_map<std::string_view, SourceRange> parts = names_in_bodies_;
  for (size_t i = 0; i < tokens_.size(); ++i) {
    if (tokens_[i].kind != Kind::kName) continue;
    const bool alone =
        i > 0 && i + 1 < tokens_.size() && StandsAlone(tokens_[i - 1], tokens_[i + 1]);
    if (!alone) parts.emplace(tokens_[i].text, tokens_[i].range);
  }
  for (const OpenMacro& macro : open_macros_) {
    const auto part = parts.find(macro.name);
    if (part == parts.end()) {
      Replace(*macro.report, macro.body, macro.value.Text());
      const auto kept = macro_by_name_.find(macro.name);
      if (kept != macro_by_name_.end()) macros_[kept->second].value = macro.value.AsLiteral();
      continue;
    }
    AddNote(*macro.report, part->second,
            MakeMessage("C evaluates '{0}' piece by piece here, because its body has no "
                        "parentheses; add them if {1} is meant",
                        "此处 C 会把没有括号的 '{0}' 拆开计算；如果要的是 {1}，请加上括号",
                        macro.name, macro.value.Text()));
  }
}

// `#include <...>`: the name of an existing file is put in quotes, a header of C is removed.
void Directives::CorrectAngles(Diagnostic& diagnostic, SourceRange range, SourceRange whole) const {
  std::string_view name = files_.TextOf(whole.file);
  name = name.substr(range.begin, range.end - range.begin);
  if (name.size() < 3 || name.front() != '<' || name.back() != '>') return;
  name = name.substr(1, name.size() - 2);
  if (FindInclude(std::string(name), {files_.PathOf(0)}, options_, reader_).found) {
    Replace(diagnostic, range, fmt::format("\"{}\"", name));
  } else if (IsHeaderOfC(name)) {
    AddNote(diagnostic,
            MakeMessage("programs have no C library, and abs and fabs need none; remove this line",
                        "运动程序没有 C 语言的库，abs 和 fabs 不需要它；请去掉"));
    Replace(diagnostic, whole, "");
  }
}

void Directives::Include(const std::vector<Token>& line, SourceRange whole) {
  if (line.size() < 3 || line[2].kind != Kind::kString || line[2].text.front() != '"') {
    SourceRange range = whole;
    Message what = MakeMessage("the end of the line", "行尾");
    if (line.size() >= 3) {
      range = {whole.file, line[2].range.begin, whole.end};
      const std::string_view text = files_.TextOf(whole.file);
      what = ToMessage(fmt::format("'{}'", text.substr(range.begin, range.end - range.begin)));
    }
    Diagnostic& diagnostic = reporter_.Report(Code::kBadFileName, range, what);
    if (line.size() >= 3) CorrectAngles(diagnostic, range, whole);
    return;
  }
  std::string_view quoted = line[2].text;
  if (quoted.size() < 2 || quoted.back() != '"') return;  // the lexer has reported it
  const std::string name(quoted.substr(1, quoted.size() - 2));
  if (name.empty() || line.size() > 3) {
    const Token& at = name.empty() ? line[2] : line[3];
    reporter_.Report(Code::kBadFileName, at.range, DescribeToken(at));
    return;
  }
  if (whole.file != 0) {
    reporter_.Report(Code::kNestedInclude, whole);
    return;
  }
  IncludedFile file = FindInclude(name, {files_.PathOf(0)}, options_, reader_);
  if (!file.found) {
    ReportMissingInclude(name, line[2].range, file, options_, reporter_);
    return;
  }
  AddFile(SourceFile(std::move(file.path), std::move(file.text)), whole.begin);
}

}  // namespace oncard::compiler
