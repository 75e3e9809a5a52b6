// Writes scenarios and reads the short forms of the command line. scenario_toml.cc reads files.
#include "runtime/scenario/file/scenario.h"

#include <fmt/format.h>
#include <filesystem>

#include "base/files.h"
#include "base/number.h"
#include "base/path_bytes.h"
#include "base/split.h"
#include "base/trim.h"
#include "gtcalls/family.h"
#include "runtime/scenario/file/key_table.h"
#include "runtime/scenario/file/keyed_toml.h"
#include "vm/limits.h"

namespace oncard::runtime {
namespace {

/// Empty when there are none.
std::string FormatExpectations(const std::vector<Expectation>& expectations) {
  if (expectations.empty()) return {};
  std::vector<std::string> texts;
  texts.reserve(expectations.size());
  for (const Expectation& expectation : expectations) texts.push_back(expectation.text());
  return FormatValue(KeyType::Texts(), texts);
}

/// A list of inline tables; empty when there are none.
template <typename Structure>
std::string FormatTables(const std::vector<Structure>& structures,
                         std::span<const Key<Structure>> rows) {
  if (structures.empty()) return {};
  std::vector<std::string> tables;
  tables.reserve(structures.size());
  for (const Structure& structure : structures) {
    tables.push_back(AsInlineTable(WriteKeys(structure, rows)));
  }
  return fmt::format("[{}]", fmt::join(tables, ", "));
}

std::string FormatThread(const ThreadStart& start) {
  std::vector<std::string> keys = WriteKeys(start, ThreadKeys(), [&](std::string_view key) {
    const bool later = key == "init" || (key == "priority" && start.period_ms == 0);
    return later ? SpecialText("") : std::nullopt;
  });
  if (!start.values.empty()) {
    keys.push_back("init = " + FormatValue(KeyType::Values(), start.values));
  }
  return AsTable("[[thread]]", keys);
}

Error BadThreadStart(std::string_view text) {
  return MakeError(1, "'{0}' is not a thread: expected N=function[@page][:name=value,...]",
                   "“{0}”不是线程描述：应为 N=函数[@页][:变量=值,...]", text);
}

/// Reads the number of a thread or a page.
Result<int> ReadIndex(std::string_view number, int count, const Message& what,
                      std::string_view text) {
  const auto index = ReadWhole<int>(number);
  if (!index) return BadThreadStart(text);
  if (*index >= 0 && *index < count) return *index;
  return MakeError(1, "{0} {1} in '{2}': it must be from 0 to {3}",
                   "“{2}”中的{4} {1}：应为 0 至 {3}", what.en, *index, text, count - 1, what.zh);
}

}  // namespace

bool MayLastForEver(const Scenario& scenario) {
  return scenario.endless || scenario.livelock != Scenario{}.livelock;
}

bool MayDeadlock(const Scenario& scenario) { return scenario.deadlock != Scenario{}.deadlock; }

TextPlace PlaceOfText(const Scenario& scenario, std::string_view key, size_t index) {
  const auto places = scenario.text_places.find(key);
  const bool known = places != scenario.text_places.end() && index < places->second.size();
  return known ? places->second[index] : TextPlace{};
}

std::string FormatScenario(const Scenario& scenario) {
  const auto card = gtcalls::FindCard(scenario.card);
  const auto special = [&](std::string_view key) -> SpecialText {
    if (key == "double") {
      return scenario.double_format == vm::DoubleFormat::k16_16 ? "\"16.16\"" : "\"32.16\"";
    }
    if (key == "expect") return FormatExpectations(scenario.expectations);
    if (key == "explore" && scenario.explore) {
      return AsInlineTable(WriteKeys(*scenario.explore, WishKeys()));
    }
    if (key == "keys") return FormatTables(scenario.keys, PressKeys());
    if (key == "within") return FormatTables(scenario.within, WithinKeys());
    if (key == "host" && scenario.host_program) {
      return AsInlineTable(WriteKeys(*scenario.host_program, HostProgramKeys()));
    }
    if (key == "globals") return "";  // after the keys without a table
    if (key == "cycle_us" && card && card->family->cycle_ns != 0) return "";
    return std::nullopt;
  };
  std::string text = AsTable("", WriteKeys(scenario, ScenarioKeys(), special));
  if (!scenario.globals.empty()) {
    std::vector<std::string> globals;
    for (const InitialValue& initial : scenario.globals) {
      globals.push_back(FormatInitialValue(initial));
    }
    text += AsTable("[globals]", globals);
  }
  for (const ThreadStart& start : scenario.threads) text += FormatThread(start);
  text += FormatWorld(scenario.world, scenario.axis_count);
  text += FormatBus(scenario.bus);
  text += FormatView(scenario.view);
  for (const HostEvent& event : scenario.host) {
    text += AsTable("[[host]]", WriteKeys(event, HostKeys()));
  }
  return text;
}

std::string PathFromScenario(const Scenario& scenario, const std::string& path) {
  const std::filesystem::path folder = PathOf(scenario.path).parent_path();
  return FileNameOf((folder / PathOf(path)).lexically_normal());
}

std::string PathToScenario(const Scenario& scenario, const std::string& path) {
  const std::filesystem::path folder = PathOf(scenario.path).parent_path();
  if (folder.empty() || PathOf(path).is_absolute()) return path;
  return NameFromFolder(path, FileNameOf(folder));
}

std::string TitleOf(const Scenario& scenario) {
  if (!scenario.title.empty()) return scenario.title;
  const std::string& path = scenario.path.empty() ? scenario.program : scenario.path;
  return FileNameOf(PathOf(path).stem());
}

std::string ProgramPath(const Scenario& scenario) {
  return PathFromScenario(scenario, scenario.program);
}

compiler::Options CompileOptions(const Scenario& scenario) {
  compiler::Options options;
  options.double_format = scenario.double_format;
  options.structured = scenario.structured;
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
  if (moved.host_program && !moved.host_program->source.empty()) {
    moved.host_program->source = move(moved.host_program->source);
  }
  if (!moved.mram.empty()) moved.mram = move(moved.mram);
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
  const auto thread = ReadIndex(text.substr(0, equals), vm::kThreadCount, {"thread", "线程"}, text);
  if (!thread.ok()) return thread.error();
  start.thread = thread.value();
  start.page = thread.value();
  const std::string_view target = text.substr(equals + 1);
  const size_t colon = target.find(':');
  std::string_view function = target.substr(0, colon);
  if (const size_t at = function.find('@'); at != std::string_view::npos) {
    const auto page = ReadIndex(function.substr(at + 1), vm::kPageCount, {"page", "数据页"}, text);
    if (!page.ok()) return page.error();
    start.page = page.value();
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

Result<InitialValue> ParseValueRange(std::string_view text) {
  const size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = Trim(text.substr(0, equals));
  const std::string_view range = text.substr(std::min(equals + 1, text.size()));
  const size_t dots = std::min(range.find(".."), range.size());
  const auto first = ReadWhole<int64_t>(Trim(range.substr(0, dots)));
  const auto last = ReadWhole<int64_t>(Trim(range.substr(std::min(dots + 2, range.size()))));
  if (name.empty() || !first || !last || !IsChoice(*first, *last)) {
    return MakeError(1,
                     "'{0}' is not a choice: expected name = first..last with whole numbers, the "
                     "smaller one first, as in x = 0..3",
                     "“{0}”不是选择：应为 变量 = 首值..末值，二者为整数且小者在前，如 x = 0..3",
                     text);
  }
  return InitialValue{std::string(name), {static_cast<double>(*first)}, {}, *last};
}

}  // namespace oncard::runtime
