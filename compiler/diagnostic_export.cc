// Diagnostics in formats for programs: JSON lines, and SARIF 2.1.0 (OASIS standard, sections 3.13
// to 3.57). Both end with a newline and depend only on their input.
// Tested by tests/compiler/printer_export_test.cc.
#include <fmt/core.h>

#include <map>
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "base/path_bytes.h"
#include "compiler/diagnostic_printer.h"

namespace oncard::compiler {
namespace {

using Json = nlohmann::ordered_json;

std::string Dump(const Json& json, int indent) { return JsonText(json, indent) + '\n'; }

const SourceFile* FileOf(const Compilation& compilation, const SourceRange& range) {
  const size_t index = static_cast<size_t>(range.file);
  return range.file >= 0 && index < compilation.files.size() ? &compilation.files[index] : nullptr;
}

std::string_view SeverityName(Severity severity) {
  return severity == Severity::kError ? "error" : "warning";
}

// --- JSON lines --------------------------------------------------------------------------------

void AddPlace(Json& json, const Compilation& compilation, const SourceRange& range) {
  const SourceFile* file = FileOf(compilation, range);
  if (file == nullptr) return;
  json["file"] = file->path();
  json["line"] = file->LineOf(range.begin);
  json["column"] = file->ColumnOf(range.begin);
  json["end_line"] = file->LineOf(range.end);
  json["end_column"] = file->ColumnOf(range.end);
}

void AddMessage(Json& json, const Message& message, Language language) {
  json["message"] = message.In(language);
  json["message_en"] = message.en;
  json["message_zh"] = message.zh;
}

Json DiagnosticToJson(const Compilation& compilation, const Diagnostic& diagnostic,
                      Language language) {
  Json json;
  json["code"] = DiagnosticName(diagnostic.info->code);
  json["severity"] = SeverityName(diagnostic.severity);
  json["slug"] = diagnostic.info->slug;
  AddMessage(json, diagnostic.message, language);
  AddPlace(json, compilation, diagnostic.range);
  json["notes"] = Json::array();
  for (const Note& note : diagnostic.notes) {
    Json item;
    AddMessage(item, note.message, language);
    if (note.has_place) AddPlace(item, compilation, note.range);
    json["notes"].push_back(std::move(item));
  }
  json["fixits"] = Json::array();
  for (const FixIt& fixit : diagnostic.fixits) {
    Json item;
    AddPlace(item, compilation, fixit.range);
    item["begin_offset"] = fixit.range.begin;
    item["end_offset"] = fixit.range.end;
    item["text"] = fixit.text;
    json["fixits"].push_back(std::move(item));
  }
  return json;
}

// --- SARIF -------------------------------------------------------------------------------------

// A path as a URI reference: characters that RFC 3986 does not allow in a path are percent-encoded.
std::string UriOf(const std::string& path) {
  const std::filesystem::path file = PathOf(path);
  const std::string name = FileNameOf(file);
  // Before a drive there is another /.
  const std::string_view root = name.starts_with('/') ? "file://" : "file:///";
  std::string uri(file.is_absolute() ? root : "");
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool digit = c >= '0' && c <= '9';
    if (letter || digit || std::string_view("/-._~").find(c) != std::string_view::npos) {
      uri += c;
    } else {
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return uri;
}

Json Region(const SourceFile& file, const SourceRange& range) {
  return {{"startLine", file.LineOf(range.begin)},
          {"startColumn", file.ColumnOf(range.begin)},
          {"endLine", file.LineOf(range.end)},
          {"endColumn", file.ColumnOf(range.end)}};
}

Json ArtifactLocation(const SourceFile& file) { return {{"uri", UriOf(file.path())}}; }

Json Location(const Compilation& compilation, const SourceRange& range) {
  const SourceFile* file = FileOf(compilation, range);
  Json location;
  if (file != nullptr) {
    location["physicalLocation"] = {{"artifactLocation", ArtifactLocation(*file)},
                                    {"region", Region(*file, range)}};
  }
  return location;
}

// One fix: all edits of the diagnostic, grouped by file as SARIF requires.
Json Fix(const Compilation& compilation, const Diagnostic& diagnostic) {
  std::map<int, Json> replacements;
  for (const FixIt& fixit : diagnostic.fixits) {
    const SourceFile* file = FileOf(compilation, fixit.range);
    if (file == nullptr) continue;
    replacements[fixit.range.file].push_back({{"deletedRegion", Region(*file, fixit.range)},
                                              {"insertedContent", {{"text", fixit.text}}}});
  }
  Json changes = Json::array();
  for (auto& [file, edits] : replacements) {
    changes.push_back(
        {{"artifactLocation", ArtifactLocation(compilation.files[static_cast<size_t>(file)])},
         {"replacements", std::move(edits)}});
  }
  return {{"artifactChanges", std::move(changes)}};
}

Json ResultOf(const Compilation& compilation, const Diagnostic& diagnostic, Language language) {
  Json result;
  result["ruleId"] = DiagnosticName(diagnostic.info->code);
  result["level"] = SeverityName(diagnostic.severity);
  std::string text = diagnostic.message.In(language);
  Json related = Json::array();
  for (const Note& note : diagnostic.notes) {
    if (!note.has_place) {
      text += '\n' + note.message.In(language);
      continue;
    }
    Json location = Location(compilation, note.range);
    location["message"]["text"] = note.message.In(language);
    related.push_back(std::move(location));
  }
  result["message"]["text"] = text;
  result["locations"] = Json::array({Location(compilation, diagnostic.range)});
  if (!related.empty()) result["relatedLocations"] = std::move(related);
  if (!diagnostic.fixits.empty()) {
    result["fixes"] = Json::array({Fix(compilation, diagnostic)});
  }
  return result;
}

}  // namespace

std::string PrintJson(const Compilation& compilation, const PrintOptions& options) {
  std::string text;
  for (const Json& diagnostic : DiagnosticsJson(compilation, options.language)) {
    text += Dump(diagnostic, -1);
  }
  return text;
}

nlohmann::ordered_json DiagnosticsJson(const Compilation& compilation, Language language) {
  Json all = Json::array();
  for (const Diagnostic& diagnostic : compilation.diagnostics) {
    all.push_back(DiagnosticToJson(compilation, diagnostic, language));
  }
  return all;
}

std::string PrintSarif(std::span<const Compilation> compilations, const PrintOptions& options) {
  std::map<int, const DiagnosticInfo*> used;
  Json results = Json::array();
  for (const Compilation& compilation : compilations) {
    for (const Diagnostic& diagnostic : compilation.diagnostics) {
      used[diagnostic.info->code] = diagnostic.info;
      results.push_back(ResultOf(compilation, diagnostic, options.language));
    }
  }
  Json rules = Json::array();
  for (const auto& [code, info] : used) {
    rules.push_back({{"id", DiagnosticName(code)},
                     {"name", info->slug},
                     {"defaultConfiguration", {{"level", SeverityName(info->severity)}}}});
  }
  Json run;
  run["tool"]["driver"] = {{"name", "oncard"}, {"rules", std::move(rules)}};
  run["language"] = options.language == Language::kChinese ? "zh-CN" : "en";
  run["columnKind"] = "unicodeCodePoints";
  run["results"] = std::move(results);
  const Json document = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                         {"version", "2.1.0"},
                         {"runs", Json::array({std::move(run)})}};
  return Dump(document, 2);
}

}  // namespace oncard::compiler
