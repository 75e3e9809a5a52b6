#include "compiler/directives.h"

#include <algorithm>

#include "base/files.h"
#include "compiler/lexer.h"
#include "compiler/parser.hh"
#include "vm/limits.h"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;

std::string FolderOf(const std::string& path) {
  const size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

std::string InFolder(const std::string& folder, const std::string& name) {
  if (folder.empty() || folder.back() == '/' || folder.back() == '\\') return folder + name;
  return folder + '/' + name;
}

bool IsNumber(const Token& token) {
  return token.kind == Kind::kInteger || token.kind == Kind::kFixed;
}

// Words are what the lexer calls names and keywords: all may follow `#`.
bool IsWord(const Token& token) {
  return !token.text.empty() &&
         (std::isalpha(static_cast<unsigned char>(token.text[0])) != 0 || token.text[0] == '_');
}

}  // namespace

void Directives::Run(SourceFile program) {
  AddFile(std::move(program), 0);
  if (refused_) tokens_.clear();
  Token end;
  end.kind = Kind::kEnd;
  const uint32_t size = static_cast<uint32_t>(files_[0].text().size());
  end.range = {0, size, size};
  end.on_new_line = true;
  tokens_.push_back(end);
}

bool Directives::Admit(const SourceFile& file) {
  if (refused_) return false;
  if (file.text().size() <= kSourceKind.bytes_max - read_bytes_) {
    read_bytes_ += file.text().size();
    return true;
  }
  Refuse(MakeMessage("the program and what it includes have more than {0} bytes",
                     "程序及其包含的文件超过 {0} 字节", kSourceKind.bytes_max));
  return false;
}

void Directives::Refuse(const Message& why) {
  refused_ = true;
  const SourceRange start = {static_cast<int>(files_.size()) - 1, 0, 0};
  reporter_.Report(Code::kCannotOpen, start, files_.back().path(), why);
}

void Directives::AddFile(SourceFile file, uint32_t inclusion_point) {
  const int index = static_cast<int>(files_.size());
  files_.push_back(std::move(file));
  inclusion_points_.push_back(inclusion_point);
  if (!Admit(files_.back())) return;
  // One more than is allowed tells a program that has too many.
  const size_t token_max = kTokenMax - scanned_tokens_;
  const std::vector<Token> tokens = Tokenize(files_.back(), index, token_max + 1, reporter_);
  if (tokens.size() > token_max) {
    Refuse(MakeMessage("the program has more than {0} tokens", "程序的记号超过 {0} 个", kTokenMax));
    return;
  }
  scanned_tokens_ += tokens.size();
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
    tokens_.push_back(token);
    ++i;
  }
  // A function cannot go on after the end of an included file.
  if (index == 0) return;
  const uint32_t size = static_cast<uint32_t>(files_[static_cast<size_t>(index)].text().size());
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
    const std::string_view text = files_[static_cast<size_t>(whole.file)].text();
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
      Message what = MakeMessage("empty", "空的");
      SourceRange range = name.range;
      if (line.size() > 3) {
        range = {whole.file, line[3].range.begin, whole.end};
        const std::string_view text = files_[static_cast<size_t>(whole.file)].text();
        what = ToMessage(fmt::format("'{}'", text.substr(range.begin, range.end - range.begin)));
      }
      reporter_.Report(Code::kMacroBody, range, name.text, what);
    }
  }
  if (macros_.size() == vm::kMacroMax) {
    // One report is enough, all that follow are too many as well.
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

std::string Directives::FindInclude(const std::string& name, std::string* text,
                                    std::optional<Message>* unreadable) const {
  std::vector<std::string> paths = {FolderOf(files_[0].path()) + name};
  if (name.front() == '/') paths = {name};
  for (const std::string& folder : options_.include_folders) {
    if (name.front() != '/') paths.push_back(InFolder(folder, name));
  }
  for (const std::string& path : paths) {
    Result<std::string> content = reader_(path);
    if (content.ok()) {
      *text = std::move(content).value();
      return path;
    }
    if (content.error().code != kNoSuchFile) {
      *unreadable = content.error().message;
      return {};
    }
  }
  return {};
}

void Directives::Include(const std::vector<Token>& line, SourceRange whole) {
  if (line.size() < 3 || line[2].kind != Kind::kString || line[2].text.front() != '"') {
    SourceRange range = whole;
    Message what = MakeMessage("the end of the line", "行尾");
    if (line.size() >= 3) {
      range = {whole.file, line[2].range.begin, whole.end};
      const std::string_view text = files_[static_cast<size_t>(whole.file)].text();
      what = ToMessage(fmt::format("'{}'", text.substr(range.begin, range.end - range.begin)));
    }
    reporter_.Report(Code::kBadFileName, range, what);
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
  std::string text;
  std::optional<Message> unreadable;
  const std::string path = FindInclude(name, &text, &unreadable);
  if (unreadable) {
    reporter_.Report(Code::kCannotOpen, line[2].range, name, *unreadable);
    return;
  }
  if (path.empty()) {
    Diagnostic& diagnostic =
        reporter_.Report(Code::kCannotOpen, line[2].range, name,
                         MakeMessage("it is neither beside the program nor in an include folder",
                                     "程序所在目录和包含目录中都没有该文件"));
    for (const std::string& folder : options_.include_folders) {
      AddNote(diagnostic, MakeMessage("searched in '{}'", "已搜索 '{}'", folder));
    }
    return;
  }
  AddFile(SourceFile(path, std::move(text)), whole.begin);
}

}  // namespace oncard::compiler
