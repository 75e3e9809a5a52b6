// The JSON of search files: what writes it, and what reads it with the type and range of every
// value. For search_text.cc and unit_search.cc. Tested by tests/explore/search_file_test.cc.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json_text.h"
#include "base/number.h"
#include "base/result.h"
#include "explore/engines/dpor.h"
#include "explore/models/ends.h"
#include "explore/models/model.h"
#include "explore/models/state_key.h"

namespace oncard::explore {

/// Not the ordered one, which looks at all keys of an object for each that it reads.
using SearchJson = nlohmann::json;

/// Maximum of counts: large enough for any search, small enough that files can be added up.
inline constexpr int64_t kCountMax = 1'000'000'000'000'000;

/// Writes the text directly: as a document in memory, the plans of a long search would take several
/// times the space of the search, and longer than many a time limit leaves.
class SearchWriter {
 public:
  std::string Take() { return std::exchange(text_, {}); }

  /// Begins a value: the next one of the list, or that with a key of the object.
  void Next() {
    if (const char last = text_.empty() ? '[' : text_.back(); last != '[' && last != '{') {
      text_ += ',';
    }
  }
  void Next(std::string_view key) {
    Next();
    fmt::format_to(std::back_inserter(text_), "\"{}\":", key);
  }
  void Open(char bracket) { text_ += bracket; }
  void Close(char bracket) { text_ += bracket; }

  void Put(std::string_view key, int64_t number) {
    Next(key);
    PutNumber(number);
  }
  void PutUnsigned(std::string_view key, uint64_t number) {
    Next(key);
    PutNumber(number);
  }
  void PutFlag(std::string_view key, bool flag) {
    Next(key);
    text_ += flag ? "true" : "false";
  }
  void PutText(std::string_view key, std::string_view text) {
    Next(key);
    text_ += JsonText(nlohmann::ordered_json(text));
  }
  template <typename Number>
  void PutList(std::string_view key, const std::vector<Number>& numbers) {
    Next(key);
    PutNumbers(numbers);
  }
  void PutPlans(std::string_view key, const std::vector<PlannedStep>& plans) {
    Next(key);
    Open('[');
    for (const PlannedStep& plan : plans) {
      Next();
      PutNumber(plan.thread);
      text_ += ',';
      PutNumber(plan.next);
    }
    Close(']');
  }
  void PutKeys(std::string_view key, const std::vector<StateKey>& keys) {
    Next(key);
    Open('[');
    for (const StateKey& state : keys) {
      Next();
      fmt::format_to(std::back_inserter(text_), "\"{:016x}{:016x}\"", state.low, state.high);
    }
    Close(']');
  }
  void PutEnds(std::string_view key, const EndSet& ends) {
    Next(key);
    Open('[');
    for (const End& end : ends.ends()) {
      Next();
      PutNumbers(end);
    }
    Close(']');
  }

 private:
  template <typename Number>
  void PutNumber(Number number) {
    if (number >= 0 && number <= 9) {
      text_ += static_cast<char>('0' + number);
      return;
    }
    const fmt::format_int digits(number);
    text_.append(digits.data(), digits.size());
  }
  template <typename Number>
  void PutNumbers(const std::vector<Number>& numbers) {
    Open('[');
    for (const Number number : numbers) {
      Next();
      PutNumber(number);
    }
    Close(']');
  }

  std::string text_;
};

/// A value of the file and its path.
class SearchValue {
 public:
  SearchValue(const SearchJson& json, const SearchValue* parent, std::string_view key)
      : json_(json), parent_(parent), key_(key) {}
  SearchValue(const SearchJson& json, const SearchValue* parent, size_t index)
      : json_(json), parent_(parent), index_(index) {}

  const SearchJson& json() const { return json_; }
  /// `traces.units[3].prefix`.
  std::string Place() const {
    if (parent_ == nullptr) return std::string(key_);
    const std::string before = parent_->Place();
    if (key_.empty()) return fmt::format("{}[{}]", before, index_);
    return before.empty() ? std::string(key_) : fmt::format("{}.{}", before, key_);
  }

 private:
  const SearchJson& json_;
  const SearchValue* parent_;
  std::string_view key_;
  size_t index_ = 0;
};

/// Reads values with their types from the file, and keeps the first one that has another type.
class SearchReader {
 public:
  bool failed() const { return failed_; }
  Error error() const { return {1, error_}; }

  SearchValue Member(const SearchValue& object, std::string_view key) {
    static const SearchJson kAbsent;
    if (!object.json().is_object()) Fail(object, "an object", "对象");
    const auto found = object.json().is_object() ? object.json().find(key) : object.json().end();
    const bool there = object.json().is_object() && found != object.json().end();
    return {there ? *found : kAbsent, &object, key};
  }

  /// Whole numbers from `least` to `most`.
  template <typename Number = int64_t>
  Number Whole(const SearchValue& value, Number least, Number most) {
    const SearchJson& json = value.json();
    const bool small = json.is_number_integer() && !json.is_number_unsigned();
    if (small && std::in_range<Number>(json.get<int64_t>())) {
      const auto number = static_cast<Number>(json.get<int64_t>());
      if (number >= least && number <= most) return number;
    }
    if (json.is_number_unsigned() && std::in_range<Number>(json.get<uint64_t>())) {
      const auto number = static_cast<Number>(json.get<uint64_t>());
      if (number >= least && number <= most) return number;
    }
    Fail(value, fmt::format("a whole number from {} to {}", +least, +most),
         fmt::format("{} 至 {} 的整数", +least, +most));
    return least;
  }
  int64_t Count(const SearchValue& value) { return Whole<int64_t>(value, 0, kCountMax); }

  bool Flag(const SearchValue& value) {
    if (!value.json().is_boolean()) Fail(value, "true or false", "true 或 false");
    return value.json() == true;
  }

  std::string Text(const SearchValue& value) {
    if (value.json().is_string()) return value.json().get<std::string>();
    Fail(value, "a text", "文本");
    return {};
  }

  uint64_t Key(const SearchValue& value) {
    const std::string text = Text(value);
    const auto key = text.size() == 16 ? ReadWhole<uint64_t>(text, 16) : std::nullopt;
    if (!key) Fail(value, "16 hexadecimal digits", "16 位十六进制数");
    return key.value_or(0);
  }

  /// Calls `take` with each element.
  template <typename Take>
  void Each(const SearchValue& list, const Take& take) {
    if (!list.json().is_array()) return Fail(list, "a list", "列表");
    for (size_t i = 0; i < list.json().size() && !failed_; ++i) {
      take(SearchValue(list.json()[i], &list, i));
    }
  }

  template <typename Number>
  std::vector<Number> Wholes(const SearchValue& list, Number least, Number most) {
    std::vector<Number> numbers;
    Each(list,
         [&](const SearchValue& value) { numbers.push_back(Whole<Number>(value, least, most)); });
    return numbers;
  }
  /// Threads of the model, at most as many as there can be.
  std::vector<uint8_t> Threads(const SearchValue& list) {
    return Wholes<uint8_t>(list, 0, kThreadMax - 1);
  }

  /// In ascending order, without duplicates.
  std::vector<StateKey> Keys(const SearchValue& list) {
    std::vector<StateKey> keys;
    Each(list, [&](const SearchValue& value) {
      const std::string text = Text(value);
      const auto low = ReadWhole<uint64_t>(std::string_view(text).substr(0, 16), 16);
      const auto high = text.size() == 32
                            ? ReadWhole<uint64_t>(std::string_view(text).substr(16), 16)
                            : std::nullopt;
      const StateKey key = {low.value_or(0), high.value_or(0)};
      if (!low || !high || (!keys.empty() && !(keys.back() < key))) {
        Fail(value, "32 hexadecimal digits, greater than the previous ones",
             "32 位十六进制数，且大于前一个");
      }
      keys.push_back(key);
    });
    return keys;
  }

  EndSet Ends(const SearchValue& list) {
    EndSet ends;
    Each(list,
         [&](const SearchValue& end) { ends.Add(Wholes<int64_t>(end, INT64_MIN, INT64_MAX)); });
    return ends;
  }

  /// Keeps the error: what was expected of a value.
  void Fail(const SearchValue& value, std::string_view expected_en, std::string_view expected_zh) {
    if (failed_) return;
    failed_ = true;
    if (value.json().is_null()) {
      error_ = MakeMessage("'{0}' is missing: expected {1}", "缺少“{0}”：应为{2}", value.Place(),
                           expected_en, expected_zh);
      return;
    }
    constexpr size_t kShown = 40;
    std::string found = value.json().dump(-1, ' ', true, SearchJson::error_handler_t::replace);
    if (found.size() > kShown) found = found.substr(0, kShown) + "...";
    error_ = MakeMessage("'{0}' is {1}: expected {2}", "“{0}”为 {1}：应为{3}", value.Place(), found,
                         expected_en, expected_zh);
  }

 private:
  bool failed_ = false;
  Message error_;
};

}  // namespace oncard::explore
