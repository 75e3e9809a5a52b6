// Writes scenarios and reads the short forms of the command line. scenario_toml.cc reads files.
#include "runtime/scenario/scenario.h"

#include <filesystem>

#include "base/files.h"
#include "base/milliseconds.h"
#include "base/number.h"
#include "base/trim.h"
#include "vm/limits.h"

namespace oncard::runtime {
namespace {

// A basic TOML string.
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

std::string TomlStrings(const std::vector<std::string>& texts) {
  std::vector<std::string> quoted;
  quoted.reserve(texts.size());
  for (const std::string& text : texts) quoted.push_back(TomlString(text));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

std::string FormatValue(const InitialValue& initial) {
  if (initial.values.size() == 1) {
    return fmt::format("{} = {}", TomlString(initial.name), initial.values.front());
  }
  return fmt::format("{} = [{}]", TomlString(initial.name), fmt::join(initial.values, ", "));
}

// The text between the braces of an inline table.
std::string FormatValues(const std::vector<InitialValue>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const InitialValue& value : values) texts.push_back(FormatValue(value));
  return fmt::format("{{ {} }}", fmt::join(texts, ", "));
}

// An inline table.
std::string FormatWish(const ExploreWish& wish) {
  std::string text = fmt::format("{{ engine = {}, verdict = {}", TomlString(wish.engine),
                                 TomlString(wish.verdict));
  if (wish.max_executions != 0) text += fmt::format(", max_executions = {}", wish.max_executions);
  if (wish.max_states != 0) text += fmt::format(", max_states = {}", wish.max_states);
  if (wish.runs != 0) text += fmt::format(", runs = {}", wish.runs);
  if (!wish.follow.empty()) text += fmt::format(", follow = {}", TomlString(wish.follow));
  return text + " }";
}

std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (size_t begin = 0;;) {
    const size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

Error BadThreadStart(std::string_view text) {
  return MakeError(1, "'{0}' is not a thread: expected N=function[@page][:name=value,...]",
                   "“{0}”不是线程描述：应为 N=函数[@页][:变量=值,...]", text);
}

}  // namespace

TextPlace PlaceOfText(const Scenario& scenario, std::string_view key, size_t index) {
  const auto places = scenario.text_places.find(key);
  const bool known = places != scenario.text_places.end() && index < places->second.size();
  return known ? places->second[index] : TextPlace{};
}

std::string FormatScenario(const Scenario& scenario) {
  std::string text = fmt::format("program = {}\n", TomlString(scenario.program));
  if (!scenario.title.empty()) text += fmt::format("title = {}\n", TomlString(scenario.title));
  if (!scenario.include_folders.empty()) {
    text += fmt::format("include = {}\n", TomlStrings(scenario.include_folders));
  }
  text += fmt::format("double = \"{}\"\n",
                      scenario.double_format == vm::DoubleFormat::k16_16 ? "16.16" : "32.16");
  text += fmt::format("schedule = {}\n", TomlString(scenario.schedule));
  text += fmt::format("rate = {}\naxes = {}\ncycle_us = {}\nlimit_ms = {}\n", scenario.rate,
                      scenario.axis_count, scenario.cycle_us, scenario.limit_ms);
  if (scenario.until_us) text += fmt::format("until_ms = {}\n", FormatMs(*scenario.until_us));
  if (!scenario.trace.empty()) text += fmt::format("trace = {}\n", TomlStrings(scenario.trace));
  if (!scenario.expectations.empty()) {
    std::vector<std::string> texts;
    for (const Expectation& expectation : scenario.expectations)
      texts.push_back(expectation.text());
    text += fmt::format("expect = {}\n", TomlStrings(texts));
  }
  if (!scenario.final.empty()) text += fmt::format("final = {}\n", TomlStrings(scenario.final));
  if (!scenario.always.empty()) text += fmt::format("always = {}\n", TomlStrings(scenario.always));
  if (!scenario.never.empty()) text += fmt::format("never = {}\n", TomlStrings(scenario.never));
  if (!scenario.eventually.empty()) {
    text += fmt::format("eventually = {}\n", TomlStrings(scenario.eventually));
  }
  if (scenario.races != Scenario{}.races) {
    text += fmt::format("races = {}\n", TomlString(scenario.races));
  }
  if (!scenario.sync.empty()) text += fmt::format("sync = {}\n", TomlStrings(scenario.sync));
  if (scenario.explore) text += fmt::format("explore = {}\n", FormatWish(*scenario.explore));
  if (!scenario.keys.empty()) {
    std::vector<std::string> presses;
    for (const KeyPress& press : scenario.keys) {
      presses.push_back(fmt::format("{{ at_ms = {}, text = {} }}", FormatMs(press.at_us),
                                    TomlString(press.text)));
    }
    text += fmt::format("keys = [{}]\n", fmt::join(presses, ", "));
  }
  if (!scenario.globals.empty()) {
    text += "\n[globals]\n";
    for (const InitialValue& initial : scenario.globals) text += FormatValue(initial) + '\n';
  }
  for (const ThreadStart& start : scenario.threads) {
    text += fmt::format("\n[[thread]]\nthread = {}\nfunction = {}\npage = {}\n", start.thread,
                        TomlString(start.function), start.page);
    if (start.period_ms != 0) {
      text += fmt::format("period_ms = {}\npriority = {}\n", start.period_ms, start.priority);
    }
    if (!start.values.empty()) {
      text += fmt::format("init = {}\n", FormatValues(start.values));
    }
  }
  text += FormatWorld(scenario.world, scenario.axis_count);
  for (const HostEvent& event : scenario.host) {
    text += fmt::format("\n[[host]]\nat_ms = {}\nset = {}\n", FormatMs(event.at_us),
                        FormatValues(event.values));
  }
  return text;
}

std::string PathFromScenario(const Scenario& scenario, const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(scenario.path).parent_path();
  return (folder / path).lexically_normal().string();
}

std::string PathToScenario(const Scenario& scenario, const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(scenario.path).parent_path();
  if (folder.empty() || std::filesystem::path(path).is_absolute()) return path;
  return NameFromFolder(path, folder.string());
}

std::string TitleOf(const Scenario& scenario) {
  if (!scenario.title.empty()) return scenario.title;
  const std::string& path = scenario.path.empty() ? scenario.program : scenario.path;
  return std::filesystem::path(path).stem().string();
}

std::string ProgramPath(const Scenario& scenario) {
  return PathFromScenario(scenario, scenario.program);
}

compiler::Options CompileOptions(const Scenario& scenario) {
  compiler::Options options;
  options.double_format = scenario.double_format;
  for (const std::string& folder : scenario.include_folders) {
    options.include_folders.push_back(PathFromScenario(scenario, folder));
  }
  return options;
}

Scenario MoveScenario(const Scenario& scenario, const std::string& path) {
  Scenario moved = scenario;
  moved.path = path;
  const auto move = [&](const std::string& old) {
    return PathToScenario(moved, PathFromScenario(scenario, old));
  };
  moved.program = move(scenario.program);
  for (std::string& folder : moved.include_folders) folder = move(folder);
  if (moved.explore && !moved.explore->follow.empty()) {
    moved.explore->follow = move(moved.explore->follow);
  }
  return moved;
}

Scenario ScenarioOfOneRun(const Scenario& scenario) {
  Scenario run = scenario;
  run.races = Scenario{}.races;
  run.sync.clear();
  run.explore.reset();
  return run;
}

Result<ThreadStart> ParseThreadStart(std::string_view text) {
  ThreadStart start;
  const size_t equals = text.find('=');
  if (equals == std::string_view::npos) return BadThreadStart(text);
  const auto thread = ReadWhole<int>(text.substr(0, equals));
  if (!thread || *thread < 0 || *thread >= vm::kThreadCount) return BadThreadStart(text);
  start.thread = *thread;
  start.page = *thread;
  const std::string_view target = text.substr(equals + 1);
  const size_t colon = target.find(':');
  std::string_view function = target.substr(0, colon);
  if (const size_t at = function.find('@'); at != std::string_view::npos) {
    const auto page = ReadWhole<int>(function.substr(at + 1));
    if (!page || *page < 0 || *page >= vm::kPageCount) return BadThreadStart(text);
    start.page = *page;
    function = function.substr(0, at);
  }
  if (function.empty()) return BadThreadStart(text);
  start.function = function;
  if (colon == std::string_view::npos) return start;
  for (const std::string_view part : Split(target.substr(colon + 1), ',')) {
    auto initial = ParseInitialValue(part);
    if (!initial.ok()) return initial.error();
    start.values.push_back(std::move(initial).value());
  }
  return start;
}

Result<InitialValue> ParseInitialValue(std::string_view text) {
  InitialValue initial;
  const size_t equals = text.find('=');
  if (equals != std::string_view::npos && equals > 0) {
    initial.name = Trim(text.substr(0, equals));
    for (const std::string_view part : Split(text.substr(equals + 1), ',')) {
      const auto value = ReadNumber(Trim(part));
      if (!value) {
        initial.values.clear();
        break;
      }
      initial.values.push_back(*value);
    }
  }
  if (initial.values.empty()) {
    return MakeError(1, "'{0}' is not an assignment: expected name=number",
                     "“{0}”不是赋值：应为 变量=数字", text);
  }
  return initial;
}

}  // namespace oncard::runtime
