// Scenario files: TOML into the Scenario structure. Every key is known or an error; every error
// says where it is. The first error ends the reading.
// Tested by tests/runtime/scenario_parse_test.cc.
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/files.h"
#include "base/nearest.h"
#include "runtime/quantity.h"
#include "runtime/scenario.h"
#include "vm/limits.h"

namespace oncard::runtime {
namespace {

constexpr std::array<std::string_view, 16> kScenarioKeys = {
    "program",  "title",   "include", "double", "schedule", "rate",  "cycle_us", "limit_ms",
    "until_ms", "globals", "thread",  "world",  "host",     "trace", "expect",   "keys"};
constexpr std::array<std::string_view, 2> kKeyKeys = {"at_ms", "text"};
constexpr std::array<std::string_view, 6> kThreadKeys = {"thread", "function",  "page",
                                                         "init",   "period_ms", "priority"};
constexpr std::array<std::string_view, 2> kHostKeys = {"at_ms", "set"};
constexpr std::array<std::string_view, 1> kWorldKeys = {"input"};
constexpr std::array<std::string_view, 4> kInputKeys = {"type", "index", "value", "at_ms"};

class ScenarioReader {
 public:
  ScenarioReader(const std::string& path, bool program_needed)
      : path_(path), program_needed_(program_needed) {
    scenario_.path = path;
  }

  Result<Scenario> Read(std::string_view text) {
    toml::parse_result parsed = toml::parse(text, path_);
    if (!parsed) {
      const auto& error = parsed.error();
      Fail(error.source(),
           MakeMessage("not TOML: {0}", "不符合 TOML 语法：{0}", error.description()));
    } else {
      ReadScenario(parsed.table());
    }
    if (error_) return *error_;
    return std::move(scenario_);
  }

 private:
  void ReadScenario(const toml::table& table) {
    CheckKeys(table, kScenarioKeys);
    Text(table, "program", scenario_.program);
    if (program_needed_ && !table.contains("program")) {
      Fail(table.source(), {"'program' is missing: name a .c or .bin file",
                            "缺少“program”：应给出 .c 或 .bin 文件"});
    }
    Text(table, "title", scenario_.title);
    Texts(table, "include", scenario_.include_folders);
    ReadDouble(table);
    Text(table, "schedule", scenario_.schedule);
    scenario_.rate = static_cast<int>(Whole(table, "rate", scenario_.rate, 1, 1'000'000));
    ReadCycle(table);
    scenario_.limit_ms = Whole(table, "limit_ms", scenario_.limit_ms, 1, kTimeMsMax);
    if (table.contains("until_ms")) scenario_.until_us = Time(table, "until_ms");
    if (const toml::table* globals = Table(table, "globals")) {
      scenario_.globals = Values(*globals);
    }
    for (const toml::table* thread : Tables(table, "thread")) ReadThread(*thread);
    if (const toml::table* world = Table(table, "world")) {
      CheckKeys(*world, kWorldKeys);
      for (const toml::table* input : Tables(*world, "input")) ReadInput(*input);
    }
    std::stable_sort(scenario_.inputs.begin(), scenario_.inputs.end(),
                     [](const InputEvent& a, const InputEvent& b) { return a.at_us < b.at_us; });
    for (const toml::table* event : Tables(table, "host")) ReadHost(*event);
    std::stable_sort(scenario_.host.begin(), scenario_.host.end(),
                     [](const HostEvent& a, const HostEvent& b) { return a.at_us < b.at_us; });
    Texts(table, "trace", scenario_.trace);
    ReadExpectations(table);
    for (const toml::table* key : Tables(table, "keys")) ReadKeys(*key);
    std::stable_sort(scenario_.keys.begin(), scenario_.keys.end(),
                     [](const KeyPress& a, const KeyPress& b) { return a.at_us < b.at_us; });
  }

  void ReadDouble(const toml::table& table) {
    std::string format = "32.16";
    Text(table, "double", format);
    if (format == "16.16") {
      scenario_.double_format = vm::DoubleFormat::k16_16;
    } else if (format != "32.16") {
      Fail(table.get("double")->source(),
           MakeMessage("'double' is '{0}': expected \"32.16\" or \"16.16\"",
                       "“double”为“{0}”：应为 \"32.16\" 或 \"16.16\"", format));
    }
  }

  void ReadCycle(const toml::table& table) {
    scenario_.cycle_us = Whole(table, "cycle_us", scenario_.cycle_us, 125, 4000);
    if (scenario_.cycle_us % 125 != 0) {
      Fail(table.get("cycle_us")->source(),
           {"'cycle_us' must be a multiple of 125", "“cycle_us”应为 125 的倍数"});
    }
  }

  void ReadThread(const toml::table& table) {
    CheckKeys(table, kThreadKeys);
    ThreadStart start;
    start.thread = static_cast<int>(Whole(table, "thread", 0, 0, vm::kThreadCount - 1));
    start.page = static_cast<int>(Whole(table, "page", start.thread, 0, vm::kPageCount - 1));
    Text(table, "function", start.function);
    if (!table.contains("function")) {
      Fail(table.source(), {"'function' is missing: name a function of the program",
                            "缺少“function”：应给出程序中的函数名"});
    }
    if (const toml::table* init = Table(table, "init")) start.values = Values(*init);
    start.period_ms = Whole(table, "period_ms", 0, 0, kTimeMsMax);
    start.priority = static_cast<int>(Whole(table, "priority", start.priority, -32768, 32767));
    for (const ThreadStart& other : scenario_.threads) {
      if (other.thread == start.thread) {
        Fail(table.source(),
             MakeMessage("thread {0} is bound twice", "线程 {0} 被绑定两次", start.thread));
      }
    }
    scenario_.threads.push_back(std::move(start));
  }

  void ReadInput(const toml::table& table) {
    CheckKeys(table, kInputKeys);
    InputEvent event;
    std::string type = "gpi";
    Text(table, "type", type);
    if (const auto word = FindInputWord(type)) {
      event.type = *word;
    } else {
      Fail(table.source(),
           MakeMessage("no inputs are named '{0}': expected limit_positive, limit_negative, alarm, "
                       "home, gpi, arrive or mpg",
                       "没有名为“{0}”的输入：应为 limit_positive、limit_negative、alarm、home、"
                       "gpi、arrive 或 mpg",
                       type));
    }
    const int width = motion::DiWidth(event.type);
    event.index = static_cast<int>(Whole(table, "index", 0, 1, width));
    const int64_t highest = event.index == 0 ? (int64_t{1} << width) - 1 : 1;
    event.value = static_cast<uint32_t>(Whole(table, "value", -1, 0, highest));
    if (!table.contains("value")) {
      Fail(table.source(),
           {"'value' is missing: the level of the pin, 0 or 1", "缺少“value”：管脚电平，0 或 1"});
    }
    event.at_us = Time(table, "at_ms");
    scenario_.inputs.push_back(event);
  }

  void ReadHost(const toml::table& table) {
    CheckKeys(table, kHostKeys);
    HostEvent event;
    event.at_us = Time(table, "at_ms");
    if (const toml::table* values = Table(table, "set")) event.values = Values(*values);
    if (event.values.empty()) {
      Fail(table.source(), {"'set' is missing: the variables to write, as in { go = 1 }",
                            "缺少“set”：要写入的变量，如 { go = 1 }"});
    }
    scenario_.host.push_back(std::move(event));
  }

  void ReadKeys(const toml::table& table) {
    CheckKeys(table, kKeyKeys);
    KeyPress press;
    press.at_us = Time(table, "at_ms");
    Text(table, "text", press.text);
    if (press.text.empty()) {
      Fail(table.source(), {"'text' is missing: the keys to press", "缺少“text”：要按的键"});
    }
    scenario_.keys.push_back(std::move(press));
  }

  void ReadExpectations(const toml::table& table) {
    const toml::node* node = table.get("expect");
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    if (list == nullptr) {
      Fail(node->source(), {"'expect' must be a list of texts, as in [\"sum == 5050\"]",
                            "“expect”应为文本列表，如 [\"sum == 5050\"]"});
      return;
    }
    for (const toml::node& item : *list) {
      const auto text = item.value_exact<std::string>();
      if (!text) {
        Fail(item.source(), {"an expectation must be a text", "期望应为文本"});
        return;
      }
      auto expectation = ParseExpectation(*text);
      if (!expectation.ok()) {
        Fail(item.source(), expectation.error().message);
        return;
      }
      scenario_.expectations.push_back(std::move(expectation).value());
    }
  }

  // --- Values of keys --------------------------------------------------------------------------

  void CheckKeys(const toml::table& table, std::span<const std::string_view> known) {
    for (const auto& [key, node] : table) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
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

  void Text(const toml::table& table, std::string_view key, std::string& value) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    if (const auto text = node->value_exact<std::string>()) {
      value = *text;
    } else {
      Fail(node->source(), MakeMessage("'{0}' must be a text", "“{0}”应为文本", key));
    }
  }

  void Texts(const toml::table& table, std::string_view key, std::vector<std::string>& values) {
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
      Fail(node->source(), MakeMessage("'{0}' must be a list of texts", "“{0}”应为文本列表", key));
    }
  }

  // A whole number in a range; `absent` when the key is not there.
  int64_t Whole(const toml::table& table, std::string_view key, int64_t absent, int64_t smallest,
                int64_t largest) {
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

  // Milliseconds, whole or not, as microseconds.
  int64_t Time(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return 0;
    const auto value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !(*value >= 0 && *value <= static_cast<double>(kTimeMsMax))) {
      Fail(node->source(), MakeMessage("'{0}' must be a time in ms, from 0 to {1}",
                                       "“{0}”应为以 ms 计的时间，0 至 {1}", key, kTimeMsMax));
      return 0;
    }
    return std::llround(*value * 1000);
  }

  const toml::table* Table(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return nullptr;
    if (!node->is_table()) {
      Fail(node->source(),
           MakeMessage("'{0}' must be a table, as in [{0}]", "“{0}”应为表，如 [{0}]", key));
    }
    return node->as_table();
  }

  std::vector<const toml::table*> Tables(const toml::table& table, std::string_view key) {
    std::vector<const toml::table*> tables;
    const toml::node* node = table.get(key);
    if (node == nullptr) return tables;
    const toml::array* list = node->as_array();
    if (list != nullptr) {
      for (const toml::node& item : *list) tables.push_back(item.as_table());
    }
    if (list == nullptr || std::find(tables.begin(), tables.end(), nullptr) != tables.end()) {
      Fail(node->source(), MakeMessage("'{0}' must be a list of tables, each under [[{0}]]",
                                       "“{0}”应为表的列表，每项写在 [[{0}]] 之下", key));
      return {};
    }
    return tables;
  }

  // `name = number` and `name = [number, ...]`, in the order of the file.
  std::vector<InitialValue> Values(const toml::table& table) {
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
      } else {
        add(node);
      }
      if (!numbers) {
        Fail(key.source(), MakeMessage("'{0}' must be a number or a list of numbers",
                                       "“{0}”应为数字或数字列表", key.str()));
      }
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

  // Keeps the error that stands first in the file.
  void Fail(const toml::source_region& place, const Message& message) {
    const auto position = std::pair(place.begin.line, place.begin.column);
    if (error_ && error_place_ <= position) return;
    error_place_ = position;
    const std::string prefix = fmt::format("{}:{}:{}: ", path_, position.first, position.second);
    error_ = Error{1, {prefix + message.en, prefix + message.zh}};
  }

  const std::string& path_;
  const bool program_needed_;
  Scenario scenario_;
  std::optional<Error> error_;
  std::pair<toml::source_index, toml::source_index> error_place_;
};

}  // namespace

Result<Scenario> ParseScenario(std::string_view text, const std::string& path) {
  return ScenarioReader(path, true).Read(text);
}

Result<Scenario> LoadScenario(const std::string& path) {
  auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  return ParseScenario(text.value(), path);
}

Result<Scenario> LoadWorld(const std::string& path) {
  auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  return ScenarioReader(path, false).Read(text.value());
}

}  // namespace oncard::runtime
