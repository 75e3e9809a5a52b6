// Compilations built by hand, to test printing without compiling.
#pragma once

#include <string>
#include <string_view>

#include "compiler/compiler.h"

namespace oncard::compiler {

inline constexpr DiagnosticInfo kUndeclared = {27, Severity::kError, "undeclared", "", ""};
inline constexpr DiagnosticInfo kTruncated = {101, Severity::kWarning, "truncated", "", ""};

inline Compilation CompilationOf(std::string text, std::string path = "p.c") {
  Compilation compilation;
  compilation.files.emplace_back(std::move(path), std::move(text));
  return compilation;
}

/// The range of the first occurrence of `what` in file 0.
inline SourceRange RangeOf(const Compilation& compilation, std::string_view what) {
  const size_t begin = compilation.files[0].text().find(what);
  return {0, static_cast<uint32_t>(begin), static_cast<uint32_t>(begin + what.size())};
}

inline Diagnostic& Report(Compilation& compilation, const DiagnosticInfo& info,
                          std::string_view what, Message message) {
  Diagnostic diagnostic;
  diagnostic.info = &info;
  diagnostic.severity = info.severity;
  diagnostic.range = RangeOf(compilation, what);
  diagnostic.message = std::move(message);
  compilation.diagnostics.push_back(std::move(diagnostic));
  return compilation.diagnostics.back();
}

}  // namespace oncard::compiler
