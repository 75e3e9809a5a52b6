#include "runtime/scenario/file/keyed_toml.h"

#include <fmt/ranges.h>

#include "base/milliseconds.h"
#include "gtcalls/card_type.h"

namespace oncard::runtime {
namespace {

void ReadChoice(const toml::table& table, std::string_view key,
                std::span<const std::string_view> choices, TomlKeys& keys, std::string* value) {
  const size_t none = choices.size();
  const size_t chosen = keys.Choice(table, key, choices, none);
  if (chosen != none) *value = choices[chosen];
}

}  // namespace

// --- Reading -------------------------------------------------------------------------------------

void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys, int& value) {
  int64_t number = value;
  ReadValue(table, key, keys, number);
  value = static_cast<int>(number);
}

void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys,
               int64_t& value) {
  if (key.type.kind == KeyKind::kTime) {
    if (table.contains(key.name)) value = keys.Time(table, key.name);
    return;
  }
  value = keys.Whole(table, key.name, value, static_cast<int64_t>(key.type.smallest),
                     static_cast<int64_t>(key.type.largest));
}

void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys, double& value) {
  value = keys.Number(table, key.name, value, key.type.smallest, key.type.largest);
}

void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys, bool& value) {
  value = keys.Flag(table, key.name, value);
}

void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys,
               std::string& value) {
  if (key.type.kind == KeyKind::kCard) {
    ReadChoice(table, key.name, gtcalls::CardTypeNames(), keys, &value);
  } else if (key.type.kind == KeyKind::kChoice) {
    ReadChoice(table, key.name, key.type.choices, keys, &value);
  } else {
    keys.Text(table, key.name, value);
  }
}

void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys,
               std::vector<std::string>& value) {
  keys.Texts(table, key.name, value);
}

void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys,
               std::optional<int64_t>& value) {
  if (!table.contains(key.name)) return;
  int64_t number = 0;
  ReadValue(table, key, keys, number);
  value = number;
}

void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys,
               std::vector<InitialValue>& value) {
  if (const toml::table* values = keys.Table(table, key.name)) {
    value = keys.Values(*values, key.type.kind == KeyKind::kOpenValues);
  }
}

// --- Writing -------------------------------------------------------------------------------------

std::string TomlString(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      quoted += fmt::format("\\u{:04X}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string FormatValue(const KeyType& type, int64_t value) {
  return type.kind == KeyKind::kTime ? FormatMs(value) : fmt::format("{}", value);
}

std::string FormatValue(const KeyType&, double value) { return fmt::format("{}", value); }

std::string FormatValue(const KeyType&, bool value) { return value ? "true" : "false"; }

std::string FormatValue(const KeyType&, const std::string& value) { return TomlString(value); }

std::string FormatValue(const KeyType&, const std::vector<std::string>& value) {
  std::vector<std::string> quoted;
  quoted.reserve(value.size());
  for (const std::string& text : value) quoted.push_back(TomlString(text));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

std::string FormatValue(const KeyType& type, const std::optional<int64_t>& value) {
  return value ? FormatValue(type, *value) : std::string();
}

std::string FormatValue(const KeyType&, const std::vector<InitialValue>& value) {
  std::vector<std::string> texts;
  texts.reserve(value.size());
  for (const InitialValue& initial : value) texts.push_back(FormatInitialValue(initial));
  return AsInlineTable(texts);
}

std::string FormatInitialValue(const InitialValue& initial) {
  if (initial.last) {
    return fmt::format("{} = {{ any = [{}, {}] }}", TomlString(initial.name),
                       static_cast<int64_t>(initial.values.front()), *initial.last);
  }
  if (initial.values.size() == 1) {
    return fmt::format("{} = {}", TomlString(initial.name), initial.values.front());
  }
  return fmt::format("{} = [{}]", TomlString(initial.name), fmt::join(initial.values, ", "));
}

std::string AsTable(std::string_view header, const std::vector<std::string>& keys) {
  std::string text = header.empty() ? std::string() : fmt::format("\n{}\n", header);
  for (const std::string& key : keys) text += key + '\n';
  return text;
}

std::string AsInlineTable(const std::vector<std::string>& keys) {
  return fmt::format("{{ {} }}", fmt::join(keys, ", "));
}

}  // namespace oncard::runtime
