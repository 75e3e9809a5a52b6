#include "compiler/reporter.h"

#include <fmt/args.h>

#include <algorithm>

namespace oncard::compiler {

Diagnostic& Reporter::Add(Code code, SourceRange range, const std::vector<Message>& arguments) {
  Diagnostic& diagnostic = diagnostics_.emplace_back();
  diagnostic.info = FindDiagnostic(static_cast<int>(code));
  diagnostic.severity = diagnostic.info->severity;
  diagnostic.range = range;
  fmt::dynamic_format_arg_store<fmt::format_context> en;
  fmt::dynamic_format_arg_store<fmt::format_context> zh;
  for (const Message& argument : arguments) {
    en.push_back(argument.en);
    zh.push_back(argument.zh);
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

}  // namespace oncard::compiler
