// Reads the tables of scenario files into structures, and writes them, as the rows of key_table.h
// say. Tested by tests/runtime/key_table_test.cc and scenario_parse_test.cc.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "runtime/scenario/file/key_table.h"
#include "runtime/scenario/file/toml_keys.h"

namespace oncard::runtime {

/// Reads what a key holds, within the range of its row; `value` is unchanged when the key is absent
/// or wrong.
void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys, int& value);
void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys, int64_t& value);
void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys, double& value);
void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys, bool& value);
void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys,
               std::string& value);
void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys,
               std::vector<std::string>& value);
void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys,
               std::optional<int64_t>& value);
void ReadValue(const toml::table& table, const KeyDescription& key, TomlKeys& keys,
               std::vector<InitialValue>& value);

/// Checks that all keys of the table are known, and reads those whose row has a member.
template <typename Structure>
void ReadKeys(const toml::table& table, std::span<const Key<Structure>> rows, TomlKeys& keys,
              Structure* structure) {
  std::vector<std::string_view> known;
  for (const Key<Structure>& row : rows) known.push_back(row.about.name);
  keys.CheckKeys(table, known);
  for (const Key<Structure>& row : rows) {
    const auto read = [&](auto member) {
      if constexpr (!std::is_same_v<decltype(member), std::monostate>) {
        ReadValue(table, row.about, keys, structure->*member);
      }
    };
    std::visit(read, row.member);
  }
}

/// The row of a key that exists.
template <typename Structure>
const KeyDescription& RowOf(std::span<const Key<Structure>> rows, std::string_view name) {
  return std::ranges::find(rows, name, [](const auto& row) { return row.about.name; })->about;
}

/// A basic TOML string.
std::string TomlString(std::string_view text);

/// A value as TOML.
std::string FormatValue(const KeyType& type, int64_t value);
inline std::string FormatValue(const KeyType& type, int value) {
  return FormatValue(type, int64_t{value});
}
std::string FormatValue(const KeyType& type, double value);
std::string FormatValue(const KeyType& type, bool value);
std::string FormatValue(const KeyType& type, const std::string& value);
std::string FormatValue(const KeyType& type, const std::vector<std::string>& value);
std::string FormatValue(const KeyType& type, const std::optional<int64_t>& value);
/// The inside of an inline table.
std::string FormatValue(const KeyType& type, const std::vector<InitialValue>& value);
/// `name = number`, or another form of TomlKeys::Values().
std::string FormatInitialValue(const InitialValue& initial);

/// The text of a key that is not written as its row says; nothing: as its row says; an empty text:
/// not written at all.
using SpecialText = std::optional<std::string>;

/// The keys of a structure as `name = value`, in the order of the rows. A key is left out that has
/// its standard value, unless its row says otherwise. `special` gives the SpecialText of a name.
template <typename Structure, typename Special>
std::vector<std::string> WriteKeys(const Structure& structure, std::span<const Key<Structure>> rows,
                                   Special special) {
  // Never destroyed: it is used while a host exits.
  static const Structure& standard = *new const Structure{};
  std::vector<std::string> written;
  for (const Key<Structure>& row : rows) {
    SpecialText text = special(row.about.name);
    const auto write = [&](auto member) {
      if constexpr (!std::is_same_v<decltype(member), std::monostate>) {
        if (!row.always_written && structure.*member == standard.*member) return;
        text = FormatValue(row.about.type, structure.*member);
      }
    };
    if (!text) std::visit(write, row.member);
    if (text && !text->empty()) written.push_back(fmt::format("{} = {}", row.about.name, *text));
  }
  return written;
}

template <typename Structure>
std::vector<std::string> WriteKeys(const Structure& structure,
                                   std::span<const Key<Structure>> rows) {
  return WriteKeys(structure, rows, [](std::string_view) { return SpecialText(); });
}

/// The keys as lines below `header`, which is empty for those of the file.
std::string AsTable(std::string_view header, const std::vector<std::string>& keys);
/// The keys as an inline table.
std::string AsInlineTable(const std::vector<std::string>& keys);

}  // namespace oncard::runtime
