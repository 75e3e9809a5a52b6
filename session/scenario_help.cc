#include "session/scenario_help.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "compiler/diagnostic.h"
#include "runtime/scenario/file/scenario_schema.h"

namespace oncard::session {
namespace {

using Json = nlohmann::ordered_json;

bool IsWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-';
}

// The line of a place, divided as far as it matters here.
struct ScenarioLine {
  std::string table;  // the dotted name of the table that the line is in
  bool head = false;  // it begins with `[`
  bool comment = false;
  bool other = false;  // it continues a value
  std::string_view text;
  size_t cursor = 0;      // in the text
  size_t word_begin = 0;  // of the word around the cursor
  size_t word_end = 0;
  size_t equals = std::string_view::npos;  // the `=` after the key
};

// The name between the brackets of a table's head; empty for any other line.
std::string HeadOf(std::string_view line) {
  const size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos || line[begin] != '[') return {};
  std::string name;
  for (const char c : line.substr(begin)) {
    if (c == ']') return name;
    if (IsWordCharacter(c)) name += c;
  }
  return name;
}

ScenarioLine ReadLine(const compiler::SourceFile& file, editor::Place place) {
  ScenarioLine line;
  for (int i = std::min(place.line - 1, file.line_count()); i > 0 && line.table.empty(); --i) {
    line.table = HeadOf(file.Line(i));
  }
  line.text = file.Line(place.line);
  if (line.text.empty()) return line;
  const auto line_begin = static_cast<size_t>(line.text.data() - file.text().data());
  line.cursor = editor::OffsetOf(file, place) - line_begin;
  char quote = 0;
  for (size_t i = 0; i < line.text.size(); ++i) {
    const char c = line.text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      line.comment = line.cursor > i;
      break;
    } else if (c == '=' && line.equals == std::string_view::npos) {
      line.equals = i;
    }
  }
  const size_t first = line.text.find_first_not_of(" \t");
  line.head = first != std::string_view::npos && line.text[first] == '[';
  line.other = first != std::string_view::npos && !line.head && !IsWordCharacter(line.text[first]);
  line.word_begin = line.word_end = line.cursor;
  while (line.word_begin > 0 && IsWordCharacter(line.text[line.word_begin - 1])) --line.word_begin;
  while (line.word_end < line.text.size() && IsWordCharacter(line.text[line.word_end])) {
    ++line.word_end;
  }
  return line;
}

// A schema with the keys of a table, whether there can be several such tables or not.
const Json* WithKeys(const Json& schema) {
  if (schema.contains("properties")) return &schema;
  if (const auto items = schema.find("items"); items != schema.end()) return WithKeys(*items);
  if (const auto choices = schema.find("anyOf"); choices != schema.end()) {
    for (const Json& choice : *choices) {
      if (const Json* keys = WithKeys(choice)) return keys;
    }
  }
  return nullptr;
}

// The schema of a dotted name; nullptr if there is none.
const Json* Find(const Json& schema, std::string_view name) {
  const Json* found = &schema;
  while (!name.empty()) {
    const size_t dot = std::min(name.find('.'), name.size());
    const Json* table = WithKeys(*found);
    if (table == nullptr) return nullptr;
    const auto key = (*table)["properties"].find(std::string(name.substr(0, dot)));
    if (key == (*table)["properties"].end()) return nullptr;
    found = &*key;
    name.remove_prefix(std::min(dot + 1, name.size()));
  }
  return found;
}

std::vector<std::string> ChoicesOf(const Json& schema) {
  std::vector<std::string> choices;
  if (const auto values = schema.find("enum"); values != schema.end()) {
    for (const Json& value : *values) choices.push_back(value.dump());
  }
  if (schema.value("type", "") == "boolean") choices = {"true", "false"};
  return choices;
}

// `integer, 1 to 12` or the choices.
std::string DetailOf(const Json& schema, Language language) {
  const std::vector<std::string> choices = ChoicesOf(schema);
  if (!choices.empty()) return fmt::to_string(fmt::join(choices, ", "));
  std::string detail = schema.value("type", "");
  if (schema.contains("minimum") && schema.contains("maximum")) {
    detail += MakeMessage(", {0} to {1}", "，{0} 至 {1}", schema["minimum"].dump(),
                          schema["maximum"].dump())
                  .In(language);
  }
  return detail;
}

Json Item(const std::string& label, std::string_view kind, const Json& schema, Language language) {
  Json item = {{"label", label}, {"kind", kind}};
  const std::string detail = DetailOf(schema, language);
  if (!detail.empty()) item["detail"] = detail;
  if (schema.contains("description")) item["documentation"] = schema["description"];
  return item;
}

void AddTables(const Json& schema, const std::string& prefix, Language language, Json* items) {
  for (const auto& [name, key] : schema["properties"].items()) {
    const Json* table = WithKeys(key);
    if (table == nullptr && key.value("type", "") != "object") continue;
    items->push_back(Item(prefix + name, "table", key, language));
    if (table != nullptr) AddTables(*table, prefix + name + '.', language, items);
  }
}

Json RangeOf(const compiler::SourceFile& file, const ScenarioPlace& where,
             const ScenarioLine& line) {
  const auto begin = static_cast<uint32_t>(line.text.data() - file.text().data());
  const auto column = [&](size_t at) {
    return line.text.empty() ? 1 : file.ColumnOf(begin + static_cast<uint32_t>(at));
  };
  return {{"file", where.path},
          {"line", where.place.line},
          {"column", column(line.word_begin)},
          {"end_line", where.place.line},
          {"end_column", column(line.word_end)}};
}

std::string KeyOf(const ScenarioLine& line) {
  std::string key;
  for (const char c : line.text.substr(0, std::min(line.equals, line.text.size()))) {
    if (IsWordCharacter(c)) key += c;
  }
  return line.table.empty() ? key : line.table + '.' + key;
}

Json SchemaIn(Language language) {
  return Json::parse(runtime::ScenarioSchema(language), nullptr, false);
}

}  // namespace

Json CompleteScenario(const ScenarioPlace& where, Language language) {
  const compiler::SourceFile file(where.path, where.text);
  const ScenarioLine line = ReadLine(file, where.place);
  const Json schema = SchemaIn(language);
  Json items = Json::array();
  if (line.comment || line.other) {
    // Nothing that the schema knows.
  } else if (line.head) {
    AddTables(schema, {}, language, &items);
  } else if (line.equals < line.cursor) {
    const Json* key = Find(schema, KeyOf(line));
    const bool quoted = line.word_begin > 0 && line.text[line.word_begin - 1] == '"';
    for (const std::string& choice :
         key != nullptr ? ChoicesOf(*key) : std::vector<std::string>()) {
      const bool text = choice.starts_with('"');
      const std::string label = text ? choice.substr(1, choice.size() - 2) : choice;
      Json item = {{"label", label}, {"kind", "value"}};
      if (text && !quoted) item["insert"] = choice;
      items.push_back(std::move(item));
    }
  } else if (const Json* table = Find(schema, line.table)) {
    if (const Json* keys = WithKeys(*table)) {
      for (const auto& [name, key] : (*keys)["properties"].items()) {
        items.push_back(Item(name, "key", key, language));
      }
    }
  }
  return {{"range", RangeOf(file, where, line)}, {"items", std::move(items)}};
}

Json DescribeScenario(const ScenarioPlace& where, Language language) {
  const compiler::SourceFile file(where.path, where.text);
  const ScenarioLine line = ReadLine(file, where.place);
  const std::string name = line.head ? HeadOf(line.text) : KeyOf(line);
  if (line.comment || line.other || line.word_begin == line.word_end) return nullptr;
  const Json schema = SchemaIn(language);
  const Json* found = Find(schema, name);
  if (found == nullptr) return nullptr;
  const std::string detail = DetailOf(*found, language);
  const std::string description = found->value("description", "");
  return {{"kind", line.head ? "table" : "key"},
          {"name", name},
          {"markdown",
           fmt::format("`{}`{}{}\n\n{}\n", name, detail.empty() ? "" : ": ", detail, description)},
          {"range", RangeOf(file, where, line)}};
}

}  // namespace oncard::session
