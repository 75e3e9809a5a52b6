// Diagnostics for people and for programs: clang-like text, one JSON object per line, SARIF 2.1.0.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "compiler/compiler.h"

namespace oncard::compiler {

struct PrintOptions {
  Language language = Language::kEnglish;
  bool color = false;
};

/// `file:line:col: error MP027: ... [undeclared]`, the source line, caret and underline, notes and
/// fix-its; tabs expand to 8 columns and wide characters take two, so that carets line up.
/// Closes with a line that counts errors and warnings when there are any.
std::string PrintText(const Compilation& compilation, const PrintOptions& options);

/// One JSON object per diagnostic and line: code, severity, slug, message in the chosen language
/// and both as "message_en"/"message_zh", file, line, column, end_line, end_column, notes, fixits.
std::string PrintJson(const Compilation& compilation, const PrintOptions& options);

/// The same objects as one array.
nlohmann::ordered_json DiagnosticsJson(const Compilation& compilation, Language language);

/// One SARIF document for a whole run.
std::string PrintSarif(std::span<const Compilation> compilations, const PrintOptions& options);

}  // namespace oncard::compiler
