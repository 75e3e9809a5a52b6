#include "runtime/scenario/file/toml_keys.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "base/milliseconds.h"
#include "base/nearest.h"
#include "runtime/scenario/file/key_table.h"

namespace oncard::runtime {

size_t ColumnFinder::OffsetOf(std::string_view line, toml::source_index column) {
  if (line.data() != line_ || column < column_) {
    line_ = line.data();
    column_ = 1;
    offset_ = 0;
  }
  for (; column_ < column && offset_ < line.size(); ++column_) {
    do {
      ++offset_;
      ++walked_;
    } while (offset_ < line.size() && (static_cast<unsigned char>(line[offset_]) & 0xC0) == 0x80);
  }
  return offset_;
}

namespace {

bool IsKeyOfFile(std::string_view key) {
  return std::ranges::any_of(ScenarioKeys(),
                             [&](const Key<Scenario>& row) { return row.about.name == key; });
}

/// For a key of the file that stands in a table.
Message DescribeKeyOfFile(std::string_view key, const toml::table& table) {
  if (table.is_inline()) {
    return MakeMessage("'{0}' is a key of the whole file: move it out of this table",
                       "“{0}”是整个文件的键：应移到此表之外", key);
  }
  return MakeMessage("'{0}' is a key of the whole file: move it above the first table",
                     "“{0}”是整个文件的键：应移到第一个表之前", key);
}

/// A time in ms as microseconds; empty for anything else.
std::optional<int64_t> TimeOf(const toml::node& node) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !(*value >= 0 && *value <= static_cast<double>(kTimeMsMax))) return std::nullopt;
  return FromMs(*value);
}

/// Reads `{ any = [first, last] }`; false for anything else.
bool ReadAny(const toml::table& table, InitialValue* initial) {
  const toml::array* ends = table["any"].as_array();
  if (table.size() != 1 || ends == nullptr || ends->size() != 2) return false;
  const auto first = ends->at(0).value_exact<int64_t>();
  const auto last = ends->at(1).value_exact<int64_t>();
  if (!first || !last || !IsChoice(*first, *last)) return false;
  initial->values = {static_cast<double>(*first)};
  initial->last = *last;
  return true;
}

}  // namespace

void TomlKeys::CheckKeys(const toml::table& table, std::span<const std::string_view> known) {
  for (const auto& [key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    if (!node.is_table() && !node.is_array_of_tables() && IsKeyOfFile(key.str())) {
      Fail(key.source(), DescribeKeyOfFile(key.str(), table));
      continue;
    }
    const std::string_view near = NearestName(key.str(), known);
    if (near.empty()) {
      Fail(key.source(),
           MakeMessage("unknown key '{0}': expected one of {1}", "未知的键“{0}”：应为 {1} 之一",
                       key.str(), fmt::to_string(fmt::join(known, ", "))));
    } else {
      Fail(key.source(), MakeMessage("unknown key '{0}'; did you mean '{1}'?",
                                     "未知的键“{0}”；是否为“{1}”？", key.str(), near));
    }
  }
}

void TomlKeys::Text(const toml::table& table, std::string_view key, std::string& value) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return;
  if (const auto text = node->value_exact<std::string>()) {
    value = *text;
  } else {
    Fail(node->source(), MakeMessage("'{0}' must be a string", "“{0}”应为文本", key));
  }
}

void TomlKeys::Texts(const toml::table& table, std::string_view key,
                     std::vector<std::string>& values) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return;
  const toml::array* list = node->as_array();
  for (size_t i = 0; list != nullptr && i < list->size(); ++i) {
    const auto text = (*list)[i].value_exact<std::string>();
    if (!text) {
      list = nullptr;
      break;
    }
    values.push_back(*text);
  }
  if (list == nullptr) {
    Fail(node->source(), MakeMessage("'{0}' must be a list of strings", "“{0}”应为文本列表", key));
  }
}

std::vector<TextPlace> TomlKeys::PlacesOfTexts(const toml::table& table,
                                               std::string_view key) const {
  std::vector<TextPlace> places;
  const toml::node* node = table.get(key);
  if (node == nullptr) return places;
  const toml::array* list = node->as_array();
  if (list == nullptr) return {TextPlaceOf(node->source())};
  for (const toml::node& item : *list) places.push_back(TextPlaceOf(item.source()));
  return places;
}

TextPlace TomlKeys::PlaceOfValue(const toml::table& table, std::string_view key) const {
  const toml::node* node = table.get(key);
  return TextPlaceOf(node != nullptr ? node->source() : table.source());
}

int64_t TomlKeys::Whole(const toml::table& table, std::string_view key, int64_t absent,
                        int64_t smallest, int64_t largest) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return absent;
  const auto value = node->value_exact<int64_t>();
  if (!value || *value < smallest || *value > largest) {
    Fail(node->source(), MakeMessage("'{0}' must be a whole number from {1} to {2}",
                                     "“{0}”应为 {1} 至 {2} 的整数", key, smallest, largest));
    return absent;
  }
  return *value;
}

double TomlKeys::Number(const toml::table& table, std::string_view key, double absent,
                        double smallest, double largest) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return absent;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !(*value >= smallest && *value <= largest)) {
    Fail(node->source(), MakeMessage("'{0}' must be a number from {1} to {2}",
                                     "“{0}”应为 {1} 至 {2} 的数字", key, smallest, largest));
    return absent;
  }
  return *value;
}

bool TomlKeys::Flag(const toml::table& table, std::string_view key, bool absent) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return absent;
  const auto value = node->value_exact<bool>();
  if (!value) {
    Fail(node->source(),
         MakeMessage("'{0}' must be true or false", "“{0}”应为 true 或 false", key));
  }
  return value.value_or(absent);
}

size_t TomlKeys::Choice(const toml::table& table, std::string_view key,
                        std::span<const std::string_view> names, size_t absent) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return absent;
  const auto text = node->value_exact<std::string>();
  const auto* found = text ? std::ranges::find(names, *text).base() : names.data() + names.size();
  if (found != names.data() + names.size()) return static_cast<size_t>(found - names.data());
  Fail(node->source(), MakeMessage("'{0}' must be one of {1}", "“{0}”应为 {1} 之一", key,
                                   fmt::to_string(fmt::join(names, ", "))));
  return absent;
}

int64_t TomlKeys::Time(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return 0;
  const auto time = TimeOf(*node);
  if (!time) {
    Fail(node->source(), MakeMessage("'{0}' must be a time in ms, from 0 to {1}",
                                     "“{0}”应为以 ms 计的时间，0 至 {1}", key, kTimeMsMax));
  }
  return time.value_or(0);
}

std::optional<std::pair<int64_t, int64_t>> TomlKeys::Times(const toml::table& table,
                                                           std::string_view key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* list = node->as_array();
  if (list != nullptr && list->size() == 2) {
    const auto first = TimeOf(list->at(0));
    const auto last = TimeOf(list->at(1));
    if (first && last && *first <= *last) return std::pair(*first, *last);
  }
  Fail(
      node->source(),
      MakeMessage("'{0}' must be two times in ms from 0 to {1}, the earlier one first, as in [10, "
                  "40]",
                  "“{0}”应为两个以 ms 计的时间，0 至 {1}，早者在前，如 [10, 40]", key, kTimeMsMax));
  return std::nullopt;
}

const toml::table* TomlKeys::Table(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return nullptr;
  if (!node->is_table()) {
    Fail(node->source(),
         MakeMessage("'{0}' must be a table, as in [{0}]", "“{0}”应为表，如 [{0}]", key));
  }
  return node->as_table();
}

std::vector<const toml::table*> TomlKeys::Tables(const toml::table& table, std::string_view path) {
  std::vector<const toml::table*> tables;
  const std::string_view key = path.substr(path.rfind('.') + 1);
  const toml::node* node = table.get(key);
  if (node == nullptr) return tables;
  const toml::array* list = node->as_array();
  if (list != nullptr) {
    for (const toml::node& item : *list) tables.push_back(item.as_table());
  }
  if (list == nullptr || std::find(tables.begin(), tables.end(), nullptr) != tables.end()) {
    Fail(node->source(), MakeMessage("'{0}' must be a list of tables, each under [[{1}]]",
                                     "“{0}”应为表的列表，每项写在 [[{1}]] 之下", key, path));
    return {};
  }
  return tables;
}

std::vector<InitialValue> TomlKeys::Values(const toml::table& table, bool open) {
  std::vector<std::pair<toml::source_region, InitialValue>> placed;
  for (const auto& [key, node] : table) {
    InitialValue initial;
    initial.name = key.str();
    bool numbers = true;
    const auto add = [&](const toml::node& item) {
      numbers = numbers && item.is_number();
      initial.values.push_back(item.value<double>().value_or(0));
    };
    if (const toml::array* list = node.as_array()) {
      for (const toml::node& item : *list) add(item);
      numbers = numbers && !list->empty();
    } else if (const toml::table* any = open ? node.as_table() : nullptr) {
      numbers = ReadAny(*any, &initial);
    } else {
      add(node);
    }
    if (!numbers && IsKeyOfFile(key.str())) {
      Fail(key.source(), DescribeKeyOfFile(key.str(), table));
    } else if (!numbers && open && node.is_table()) {
      Fail(key.source(),
           MakeMessage("'{0}' must be a number, a list of numbers, or a choice between two whole "
                       "numbers, the smaller one first, as in {{ any = [1, 10] }}",
                       "“{0}”应为数字、数字列表，或两个整数之间的选择，小者在前，如 "
                       "{{ any = [1, 10] }}",
                       key.str()));
    } else if (!numbers) {
      Fail(key.source(), MakeMessage("'{0}' must be a number or a list of numbers",
                                     "“{0}”应为数字或数字列表", key.str()));
    }
    initial.place = TextPlaceOf(key.source());
    placed.emplace_back(key.source(), std::move(initial));
  }
  std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first.begin.line, a.first.begin.column) <
           std::pair(b.first.begin.line, b.first.begin.column);
  });
  std::vector<InitialValue> values;
  values.reserve(placed.size());
  for (auto& [place, initial] : placed) values.push_back(std::move(initial));
  return values;
}

void TomlKeys::Fail(const toml::source_region& place, const Message& message) {
  Fail(TextPlaceOf(place), message);
}

void TomlKeys::Fail(const TextPlace& place, const Message& message) { errors_.Add(place, message); }

toml::source_region TomlKeys::PlaceOf(size_t line, size_t column) {
  const toml::source_position position = {static_cast<toml::source_index>(line),
                                          static_cast<toml::source_index>(column)};
  return {position, position, nullptr};
}

TextPlace TomlKeys::TextPlaceOf(const toml::source_region& place) const {
  const auto line = static_cast<int>(place.begin.line);
  const auto column = static_cast<int>(place.begin.column);
  const std::string_view text = file_->Line(line);
  const bool one_line = place.end.line == place.begin.line;
  const size_t begin = columns_.OffsetOf(text, place.begin.column);
  const size_t end = columns_.OffsetOf(text, one_line ? place.end.column : place.begin.column + 1);
  return {file_, line, column, begin, end};
}

}  // namespace oncard::runtime
