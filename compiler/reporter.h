// Collects diagnostics while a program is compiled.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/diagnostic.h"

namespace oncard::compiler {

/// The rows of diagnostics.def by name.
enum class Code : int {
#define DIAGNOSTIC(code, name, severity, slug, en, zh) name = code,
#include "compiler/diagnostics.def"
};

/// An argument of a diagnostic: the same in both languages, or a phrase of its own in each.
inline Message ToMessage(Message message) { return message; }
inline Message ToMessage(std::string_view text) { return {std::string(text), std::string(text)}; }
inline Message ToMessage(int64_t number) {
  return {std::to_string(number), std::to_string(number)};
}

class Reporter {
 public:
  /// Adds a diagnostic; the arguments fill {0}, {1}, ... of its texts. The reference stays valid,
  /// for notes and fix-its to be added.
  template <typename... Args>
  Diagnostic& Report(Code code, SourceRange range, const Args&... args) {
    return Add(code, range, {ToMessage(args)...});
  }

  /// The same with the arguments in a list.
  Diagnostic& Report(Code code, SourceRange range, const std::vector<Message>& arguments) {
    return Add(code, range, arguments);
  }

  /// Removes the diagnostics of a code that another diagnostic explains.
  void Drop(Code code);

  bool HasErrors() const;
  bool Has(Code code) const;
  std::deque<Diagnostic>& diagnostics() { return diagnostics_; }

 private:
  Diagnostic& Add(Code code, SourceRange range, const std::vector<Message>& arguments);

  std::deque<Diagnostic> diagnostics_;
};

/// Adds a note with a place, or without one.
void AddNote(Diagnostic& diagnostic, SourceRange range, Message message);
void AddNote(Diagnostic& diagnostic, Message message);
/// Adds an edit: replacement of a range, or insertion before or after it.
void Replace(Diagnostic& diagnostic, SourceRange range, std::string text);
void InsertBefore(Diagnostic& diagnostic, SourceRange range, std::string text);
void InsertAfter(Diagnostic& diagnostic, SourceRange range, std::string text);

/// Sorts diagnostics, which come from the lexer, the parser and the checker in turn, by their
/// places in the source, those of an included file at its #include: `inclusion` has for each file
/// the offset in the program. Then limits their number.
void SortAndLimit(std::vector<Diagnostic>& diagnostics, const std::vector<uint32_t>& inclusion,
                  int max_errors);
/// Removes what follows after `max_errors` errors (0: no limit); a note counts the others.
void LimitErrors(std::vector<Diagnostic>& diagnostics, int max_errors);

}  // namespace oncard::compiler
