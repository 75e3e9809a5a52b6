// The keys of a TOML table, read with their types and ranges. The first error in the order of the
// file is kept, with its place; readers go on after an error with the value of an absent key.
// Tested by tests/runtime/scenario_parse_test.cc.
#pragma once

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "runtime/scenario.h"

namespace oncard::runtime {

class TomlKeys {
 public:
  /// `path` names the file in errors.
  explicit TomlKeys(std::string path) : path_(std::move(path)) {}

  /// An error for each key that is not known; it names the nearest known one.
  void CheckKeys(const toml::table& table, std::span<const std::string_view> known);
  /// Leaves `value` alone when the key is not there.
  void Text(const toml::table& table, std::string_view key, std::string& value);
  void Texts(const toml::table& table, std::string_view key, std::vector<std::string>& values);
  /// A whole number in a range; `absent` when the key is not there.
  int64_t Whole(const toml::table& table, std::string_view key, int64_t absent, int64_t smallest,
                int64_t largest);
  /// A number in a range; `absent` when the key is not there.
  double Number(const toml::table& table, std::string_view key, double absent, double smallest,
                double largest);
  /// `absent` when the key is not there.
  bool Flag(const toml::table& table, std::string_view key, bool absent);
  /// Milliseconds, whole or not, as microseconds; 0 when the key is not there.
  int64_t Time(const toml::table& table, std::string_view key);
  /// The number of a text among names; `absent` when the key is not there.
  size_t Choice(const toml::table& table, std::string_view key,
                std::span<const std::string_view> names, size_t absent);
  /// NULL when the key is not there or no table.
  const toml::table* Table(const toml::table& table, std::string_view key);
  std::vector<const toml::table*> Tables(const toml::table& table, std::string_view key);
  /// `name = number` and `name = [number, ...]`, in the order of the file.
  std::vector<InitialValue> Values(const toml::table& table);
  void Fail(const toml::source_region& place, const Message& message);

  const std::optional<Error>& error() const { return error_; }

 private:
  std::string path_;
  std::optional<Error> error_;
  std::pair<toml::source_index, toml::source_index> error_place_;
};

}  // namespace oncard::runtime
