// The keys of a TOML table, read with their types and ranges. Errors are collected with their
// places; after an error, readers continue as if the key were absent. Tested by
// tests/runtime/scenario_parse_test.cc.
#pragma once

// The library's functions are compiled once, in toml_library.cc.
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "runtime/scenario/file/placed_errors.h"
#include "runtime/scenario/file/scenario.h"

namespace oncard::runtime {

/// Finds the bytes of characters. It walks on from the one that was found last, so that many places
/// of one line, in their order, take one walk.
class ColumnFinder {
 public:
  /// The byte index of a character of a line in UTF-8; `column` is counted from 1.
  size_t OffsetOf(std::string_view line, toml::source_index column);
  /// Number of bytes walked so far.
  size_t walked() const { return walked_; }

 private:
  const char* line_ = nullptr;
  toml::source_index column_ = 1;
  size_t offset_ = 0;  ///< of column_
  size_t walked_ = 0;
};

class TomlKeys {
 public:
  /// `path` names the file in errors, `text` is its content within a margin.
  TomlKeys(std::string path, std::string_view text, TextMargin margin = {})
      : file_(std::make_shared<const TextFile>(std::move(path), text, margin)) {}

  /// Adds an error for each unknown key, with a suggestion: to move a key of the file above the
  /// first table, or the most similar known key.
  void CheckKeys(const toml::table& table, std::span<const std::string_view> known);
  /// Does not change `value` if the key is absent.
  void Text(const toml::table& table, std::string_view key, std::string& value);
  void Texts(const toml::table& table, std::string_view key, std::vector<std::string>& values);
  /// The places of those texts, or of the one text.
  std::vector<TextPlace> PlacesOfTexts(const toml::table& table, std::string_view key) const;
  /// The place of a value, or of the table if the key is missing.
  TextPlace PlaceOfValue(const toml::table& table, std::string_view key) const;
  /// A whole number in a range; `absent` if the key is missing.
  int64_t Whole(const toml::table& table, std::string_view key, int64_t absent, int64_t smallest,
                int64_t largest);
  /// A number in a range; `absent` if the key is missing.
  double Number(const toml::table& table, std::string_view key, double absent, double smallest,
                double largest);
  /// `absent` when the key is not there.
  bool Flag(const toml::table& table, std::string_view key, bool absent);
  /// Milliseconds, whole or not, as microseconds; 0 when the key is not there.
  int64_t Time(const toml::table& table, std::string_view key);
  /// Two such times, the earlier one first; empty if the key is missing.
  std::optional<std::pair<int64_t, int64_t>> Times(const toml::table& table, std::string_view key);
  /// The index of a string among names; `absent` if the key is missing.
  size_t Choice(const toml::table& table, std::string_view key,
                std::span<const std::string_view> names, size_t absent);
  /// NULL if the key is missing or not a table.
  const toml::table* Table(const toml::table& table, std::string_view key);
  /// The tables under [[path]]; the last part of the path is their key in `table`.
  std::vector<const toml::table*> Tables(const toml::table& table, std::string_view path);
  /// `name = number` and `name = [number, ...]`, in the order of the file. `open`: a value can also
  /// be `{ any = [first, last] }`.
  std::vector<InitialValue> Values(const toml::table& table, bool open = false);
  void Fail(const toml::source_region& place, const Message& message);
  void Fail(const TextPlace& place, const Message& message);

  /// A place as errors that are found later name it.
  TextPlace TextPlaceOf(const toml::source_region& place) const;
  /// A place for Fail().
  static toml::source_region PlaceOf(size_t line, size_t column);

  /// All errors in the order of the file, with their lines; empty if there are none.
  std::optional<Error> Failure() const { return errors_.Failure(); }

 private:
  std::shared_ptr<const TextFile> file_;
  mutable ColumnFinder columns_;
  PlacedErrors errors_;
};

}  // namespace oncard::runtime
