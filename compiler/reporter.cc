#include "compiler/reporter.h"

#include <tuple>

#include <fmt/args.h>

#include <algorithm>

#include "compiler/text.h"

namespace oncard::compiler {
namespace {

// What a message quotes is shortened beyond this number of bytes: its beginning and its end remain.
constexpr size_t kQuotedMax = 400;
constexpr size_t kEndOfQuoted = 40;

std::string Shortened(const std::string& text) {
  if (text.size() <= kQuotedMax) return text;
  const bool utf8 = IsUtf8(text);
  const std::string_view whole = text;
  const auto next_character = [whole, utf8](size_t from, size_t at_least) {
    while (from < at_least) from += CharacterLength(whole.substr(from), utf8);
    return from;
  };
  const size_t cut = next_character(0, kQuotedMax - kEndOfQuoted);
  const size_t end = next_character(cut, whole.size() - kEndOfQuoted);
  return std::string(whole.substr(0, cut)).append("...").append(whole.substr(end));
}

}  // namespace

Diagnostic& Reporter::Add(Code code, SourceRange range, const std::vector<Message>& arguments) {
  Diagnostic& diagnostic = diagnostics_.emplace_back();
  diagnostic.info = FindDiagnostic(static_cast<int>(code));
  diagnostic.severity = diagnostic.info->severity;
  diagnostic.range = range;
  fmt::dynamic_format_arg_store<fmt::format_context> en;
  fmt::dynamic_format_arg_store<fmt::format_context> zh;
  for (const Message& argument : arguments) {
    en.push_back(Shortened(argument.en));
    zh.push_back(Shortened(argument.zh));
  }
  diagnostic.message = {fmt::vformat(diagnostic.info->en, en),
                        fmt::vformat(diagnostic.info->zh, zh)};
  return diagnostic;
}

void Reporter::Drop(Code code) {
  std::erase_if(diagnostics_, [code](const Diagnostic& diagnostic) {
    return diagnostic.info->code == static_cast<int>(code);
  });
}

bool Reporter::HasErrors() const {
  return std::any_of(diagnostics_.begin(), diagnostics_.end(), [](const Diagnostic& diagnostic) {
    return diagnostic.severity == Severity::kError;
  });
}

bool Reporter::Has(Code code) const {
  return std::any_of(diagnostics_.begin(), diagnostics_.end(), [code](const Diagnostic& row) {
    return row.info->code == static_cast<int>(code);
  });
}

void AddNote(Diagnostic& diagnostic, SourceRange range, Message message) {
  diagnostic.notes.push_back({range, true, std::move(message)});
}

void AddNote(Diagnostic& diagnostic, Message message) {
  diagnostic.notes.push_back({{}, false, std::move(message)});
}

void Replace(Diagnostic& diagnostic, SourceRange range, std::string text) {
  diagnostic.fixits.push_back({range, std::move(text)});
}

void InsertBefore(Diagnostic& diagnostic, SourceRange range, std::string text) {
  range.end = range.begin;
  diagnostic.fixits.push_back({range, std::move(text)});
}

void InsertAfter(Diagnostic& diagnostic, SourceRange range, std::string text) {
  range.begin = range.end;
  diagnostic.fixits.push_back({range, std::move(text)});
}

void SortAndLimit(std::vector<Diagnostic>& diagnostics, const std::vector<uint32_t>& inclusion,
                  int max_errors) {
  // What an included file says stands where the program includes it.
  const auto key = [&inclusion](const Diagnostic& diagnostic) {
    const SourceRange& range = diagnostic.range;
    const uint32_t in_program =
        range.file == 0 ? range.begin : inclusion[static_cast<size_t>(range.file)];
    return std::tuple(in_program, range.file, range.begin);
  };
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [&key](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
  LimitErrors(diagnostics, max_errors);
}

void LimitErrors(std::vector<Diagnostic>& diagnostics, int max_errors) {
  if (max_errors <= 0) return;
  int errors = 0;
  for (size_t i = 0; i < diagnostics.size(); ++i) {
    if (diagnostics[i].severity != Severity::kError) continue;
    if (++errors <= max_errors) continue;
    const auto hidden =
        std::count_if(diagnostics.begin() + static_cast<std::ptrdiff_t>(i), diagnostics.end(),
                      [](const Diagnostic& rest) { return rest.severity == Severity::kError; });
    diagnostics.erase(diagnostics.begin() + static_cast<std::ptrdiff_t>(i), diagnostics.end());
    AddNote(diagnostics.back(),
            MakeMessage("{0} more errors are not shown", "还有 {0} 个错误没有显示", hidden));
    return;
  }
}

}  // namespace oncard::compiler
