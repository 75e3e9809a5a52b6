// Reads scenario files: TOML to the Scenario structure. Unknown keys are errors; every error has
// its place.
// Tested by tests/runtime/scenario_parse_test.cc.
#include <fmt/ranges.h>

#include <algorithm>

#include "base/files.h"
#include "base/milliseconds.h"
#include "gtcalls/families.h"
#include "gtcalls/family.h"
#include "runtime/scenario/file/bus_toml.h"
#include "runtime/scenario/file/key_table.h"
#include "runtime/scenario/file/keyed_toml.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/file/scenario_keys.h"
#include "runtime/scenario/file/toml_guard.h"
#include "runtime/scenario/file/toml_keys.h"
#include "runtime/scenario/file/view_toml.h"
#include "runtime/scenario/file/world_toml.h"

namespace oncard::runtime {
namespace {

class ScenarioReader : private TomlKeys {
 public:
  ScenarioReader(std::string_view text, const std::string& path, ScenarioUse use, TextMargin margin,
                 const gtcalls::CardType* host_card)
      : TomlKeys(path, text, margin), text_(text), use_(use), host_card_(host_card) {
    scenario_.path = path;
  }

  Result<Scenario> Read() {
    if (const auto refusal = CheckToml(text_)) {
      Fail(PlaceOf(refusal->line, refusal->column), refusal->message);
      return *Failure();
    }
    toml::parse_result parsed = toml::parse(text_, scenario_.path);
    if (!parsed) {
      const auto& error = parsed.error();
      Fail(error.source(),
           MakeMessage("not TOML: {0}", "不符合 TOML 语法：{0}", error.description()));
    } else {
      if (use_ == ScenarioUse::kTest && NamesHostProgram(parsed.table())) {
        use_ = ScenarioUse::kHost;
      }
      CheckUses(parsed.table());
      ReadScenario(parsed.table());
    }
    if (auto failure = Failure()) return *std::move(failure);
    return std::move(scenario_);
  }

 private:
  static bool NamesHostProgram(const toml::table& table) {
    const toml::node* host = table.get("host");
    return host != nullptr && host->is_table();
  }

  void CheckUses(const toml::table& table) {
    for (const auto& [key, node] : table) {
      const auto rule = std::ranges::find(ScenarioKeyRules(), key.str(), &KeyRule::name);
      if (rule == ScenarioKeyRules().end()) continue;
      if (key.str() == "host" && node.is_table()) {
        if (use_ != ScenarioUse::kHost && use_ != ScenarioUse::kText) {
          Fail(key.source(), DescribeRefusedHostProgram());
        }
        continue;
      }
      if (UseOfKey(*rule, use_, table.contains("explore")) == KeyUse::kRefused) {
        Fail(key.source(), DescribeRefusedKey(key.str(), use_));
      }
    }
  }

  void ReadScenario(const toml::table& table) {
    // A host program has no time limit unless the file sets one.
    if (use_ == ScenarioUse::kHost) scenario_.limit_ms = kTimeMsMax;
    ReadKeys(table, ScenarioKeys(), *this, &scenario_);
    ReadDouble(table);
    ReadCard(table);
    if (use_ != ScenarioUse::kHost && !table.contains("program") && !NamesHostProgram(table)) {
      Fail(table.source(), DescribeMissingProgram());
    }
    CheckCycle(table);
    for (const toml::table* thread : Tables(table, "thread")) ReadThread(*thread);
    if (const toml::table* world = Table(table, "world")) {
      WorldPlaces places;
      scenario_.world = ReadWorld(*world, scenario_.axis_count, *this, &places);
      scenario_.text_places[std::string(kReactionPlaces)] = std::move(places.conditions);
      scenario_.text_places[std::string(kInputPlaces)] = std::move(places.inputs);
      scenario_.text_places[std::string(kFaultPlaces)] = std::move(places.faults);
      CheckUnits(*world);
    }
    if (const toml::table* bus = Table(table, "ethercat")) {
      scenario_.bus = ReadBus(*bus, scenario_.axis_count, *this);
    }
    if (const toml::table* view = Table(table, "view")) {
      scenario_.view = ReadView(*view, scenario_.axis_count, *this);
    }
    if (NamesHostProgram(table)) {
      ReadHostProgram(*table.get("host")->as_table());
    } else {
      for (const toml::table* event : Tables(table, "host")) ReadHost(*event);
    }
    std::stable_sort(scenario_.host.begin(), scenario_.host.end(),
                     [](const HostEvent& a, const HostEvent& b) { return a.at_us < b.at_us; });
    ReadExpectations(table);
    for (const char* key : {"schedule", "trace", "final", "always", "never", "eventually", "leads",
                            "races", "sync"}) {
      scenario_.text_places[key] = PlacesOfTexts(table, key);
    }
    for (const toml::table* within : Tables(table, "within")) ReadWithin(*within);
    if (use_ == ScenarioUse::kHost) CheckRequirements();
    for (const auto& [place, why] : ClashesWithEndless(scenario_, RequirementsOf(scenario_))) {
      Fail(place, why);
    }
    ReadExplore(table);
    for (const toml::table* key : Tables(table, "keys")) ReadPress(*key);
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

  void CheckCycle(const toml::table& table) {
    if (scenario_.cycle_us % RowOf(ScenarioKeys(), "cycle_us").type.step == 0) return;
    Fail(table.get("cycle_us")->source(),
         {"'cycle_us' must be a multiple of 125", "“cycle_us”应为 125 的倍数"});
  }

  /// A card without a name is one of the first family.
  void CheckAxisCount(const toml::table& table) {
    const auto types = gtcalls::Families().front()->card_types;
    std::vector<int> counts;
    for (const gtcalls::CardType& type : types) counts.push_back(type.axis_count);
    if (std::ranges::find(counts, scenario_.axis_count) != counts.end()) return;
    Fail(table.get("axes")->source(),
         MakeMessage("'axes' must be one of {0}, the sizes of the cards",
                     "“axes”应为 {0} 之一：控制卡的轴数", fmt::to_string(fmt::join(counts, ", "))));
  }

  /// The card says how many axes there are.
  void ReadCard(const toml::table& table) {
    if (host_card_ != nullptr) {
      if (!scenario_.card.empty() && scenario_.card != host_card_->name) {
        Fail(table.get("card")->source(),
             MakeMessage("'card' is {0}, but ONCARD_CARD is {1}: change or remove one of them",
                         "“card”为 {0}，而 ONCARD_CARD 为 {1}：应修改或去掉其中之一",
                         scenario_.card, host_card_->name));
        return;
      }
      scenario_.card = host_card_->name;
    }
    const auto card = gtcalls::FindCard(scenario_.card);
    if (!card) return CheckAxisCount(table);
    if (table.contains("axes") && scenario_.axis_count != card->type->axis_count) {
      Fail(table.get("axes")->source(),
           MakeMessage("'axes' is {0}, but the card {1} has {2} axes: remove 'axes'",
                       "“axes”为 {0}，而控制卡 {1} 有 {2} 个轴：应去掉“axes”", scenario_.axis_count,
                       scenario_.card, card->type->axis_count));
    }
    scenario_.axis_count = card->type->axis_count;
    if (table.contains("cycle_us") && card->family->cycle_ns != 0) {
      Fail(table.get("cycle_us")->source(),
           MakeMessage("the card {0} itself says how long a cycle takes: remove 'cycle_us'",
                       "控制卡 {0} 的周期由其自身决定：应去掉“cycle_us”", scenario_.card));
    }
    if (!card->family->HasPrograms()) RefuseProgramKeys(table);
  }

  /// A second is no fixed number of cycles where commands count cycles.
  void CheckUnits(const toml::table& world) {
    const auto card = gtcalls::FindCard(scenario_.card);
    if (!card || card->family->cycle_ns == 0) return;
    const std::vector<MotorSetup>& motors = scenario_.world.motors;
    for (size_t i = 0; i < motors.size(); ++i) {
      if (motors[i].unit.empty()) continue;
      Fail(world["axis"][i]["unit"].node()->source(),
           MakeMessage("the card {0} counts velocities in cycles, so that axis {1} has no 'unit': "
                       "remove it, and give its numbers in pulses",
                       "控制卡 {0} 以周期计速度，轴 {1} 不能有“unit”：应去掉，并以脉冲给出数值",
                       scenario_.card, motors[i].axis));
    }
  }

  Message DescribeMissingProgram() const {
    const auto card = gtcalls::FindCard(scenario_.card);
    if (!card || card->family->HasPrograms()) {
      return {"'program' is missing: name a .c or .bin file",
              "缺少“program”：应给出 .c 或 .bin 文件"};
    }
    return MakeMessage(
        "the card {0} executes no motion programs, only the calls of a host: name it in 'host', or "
        "run it with 'oncard exec --scenario'",
        "控制卡 {0} 不执行运动程序，只执行主机的调用：应在“host”中给出主机程序，或用“oncard exec "
        "--scenario”运行它",
        scenario_.card);
  }

  /// The text of a scenario without a program has an empty one.
  void RefuseProgramKeys(const toml::table& table) {
    for (const std::string_view key : {"program", "globals", "thread"}) {
      if (!table.contains(key) || (key == "program" && scenario_.program.empty())) continue;
      Fail(
          table.get(key)->source(),
          MakeMessage("'{0}' is for motion programs, and the card {1} has none: remove it",
                      "“{0}”用于运动程序，而控制卡 {1} 没有运动程序：应去掉", key, scenario_.card));
    }
  }

  void ReadThread(const toml::table& table) {
    ThreadStart start;
    ReadKeys(table, ThreadKeys(), *this, &start);
    if (!table.contains("page")) start.page = start.thread;
    if (!table.contains("function")) {
      Fail(table.source(), {"'function' is missing: name a function of the program",
                            "缺少“function”：应给出程序中的函数名"});
    }
    start.function_place = PlaceOfValue(table, "function");
    start.page_place = PlaceOfValue(table, "page");
    if (table.contains("priority") && start.period_ms == 0) {
      Fail(table.get("priority")->source(),
           {"'priority' is only for periodic threads: add 'period_ms', or remove 'priority'",
            "“priority”只用于周期启动的线程：应加上“period_ms”，或去掉“priority”"});
    }
    for (const ThreadStart& other : scenario_.threads) {
      if (other.thread == start.thread) {
        Fail(table.source(),
             MakeMessage("thread {0} is bound twice", "线程 {0} 被绑定两次", start.thread));
      }
    }
    scenario_.threads.push_back(std::move(start));
  }

  void ReadHostProgram(const toml::table& table) {
    HostProgram host;
    ReadKeys(table, HostProgramKeys(), *this, &host);
    if (host.source.empty() == host.command.empty()) {
      Fail(table.source(), {"'host' must name either a 'source', as in { source = \"host.c\" }, or "
                            "a 'command', as in { command = [\"./host\"] }",
                            "“host”应给出“source”，如 { source = \"host.c\" }，或“command”，如 "
                            "{ command = [\"./host\"] }，二者取一"});
    }
    for (const char* key : {"flags", "arguments"}) {
      if (host.command.empty() || !table.contains(key)) continue;
      Fail(table.get(key)->source(),
           MakeMessage("'{0}' is only for a 'source': write it into 'command', or remove it",
                       "“{0}”只用于“source”：应写入“command”，或去掉", key));
    }
    scenario_.host_program = std::move(host);
  }

  void ReadHost(const toml::table& table) {
    HostEvent event;
    ReadKeys(table, HostKeys(), *this, &event);
    if (event.values.empty()) {
      Fail(table.source(), {"'set' is missing: the variables to write, as in { go = 1 }",
                            "缺少“set”：要写入的变量，如 { go = 1 }"});
    }
    if (event.after_statements) CheckAfterStatements(table, event);
    scenario_.host.push_back(std::move(event));
  }

  void CheckAfterStatements(const toml::table& table, const HostEvent& event) {
    constexpr int64_t kUsPerMs = 1000;
    const toml::source_region& place = table.get("after_statements")->source();
    const int64_t most = (scenario_.rate * scenario_.cycle_us + kUsPerMs - 1) / kUsPerMs;
    if (event.at_us == 0) {
      Fail(place,
           MakeMessage("no statement is executed at 0 ms: the first cycle is at {0} ms",
                       "0 ms 时没有语句执行：第一个周期在 {0} ms", ToMs(scenario_.cycle_us)));
    } else if (*event.after_statements >= most) {
      Fail(place,
           MakeMessage("a cycle has at most {0} statements: remove 'after_statements' for a write "
                       "at its end",
                       "一个周期至多 {0} 条语句：要在周期末写入，应去掉“after_statements”", most));
    }
  }

  void ReadPress(const toml::table& table) {
    KeyPress press;
    ReadKeys(table, PressKeys(), *this, &press);
    if (press.text.empty()) {
      Fail(table.source(), {"'text' is missing: the keys to press", "缺少“text”：要按的键"});
    }
    scenario_.keys.push_back(std::move(press));
  }

  void ReadWithin(const toml::table& table) {
    TimedResponse within;
    ReadKeys(table, WithinKeys(), *this, &within);
    for (const Key<TimedResponse>& row : WithinKeys()) {
      if (table.contains(row.about.name)) continue;
      Fail(table.source(),
           MakeMessage("'{0}' is missing: a response is written as in {{ after = \"gpi[1] == 1\", "
                       "then = \"axis1.moving == 0\", ms = 5 }}",
                       "缺少“{0}”：限时响应的写法如 {{ after = \"gpi[1] == 1\", then = "
                       "\"axis1.moving == 0\", ms = 5 }}",
                       row.about.name));
    }
    within.after_place = PlaceOfValue(table, "after");
    within.then_place = PlaceOfValue(table, "then");
    within.us_place = PlaceOfValue(table, "ms");
    scenario_.within.push_back(std::move(within));
  }

  /// A host may run for long before its program is there to read them for.
  void CheckRequirements() {
    for (const Requirement& requirement : RequirementsOf(scenario_)) {
      if (const auto form = CheckForm(requirement); !form.ok()) {
        Fail(requirement.place, form.error().message);
        continue;
      }
      const auto check = [&](const std::string& text, const TextPlace& place) {
        const auto condition = ParseCondition(text);
        if (!condition.ok()) Fail(place, condition.error().message);
      };
      check(requirement.text, requirement.place);
      if (requirement.IsResponse()) check(requirement.then, requirement.then_place);
    }
  }

  void ReadExplore(const toml::table& table) {
    const toml::node* node = table.get("explore");
    if (node == nullptr) return;
    ExploreWish wish;
    if (node->value_exact<std::string>() == "prove") {
      scenario_.explore = wish;
    } else if (const toml::table* wishes = node->as_table()) {
      ReadKeys(*wishes, WishKeys(), *this, &wish);
      scenario_.text_places["explore.engine"] = PlacesOfTexts(*wishes, "engine");
      if (use_ != ScenarioUse::kText) CheckWish(*wishes, wish);
      scenario_.explore = std::move(wish);
    } else {
      Fail(node->source(),
           {"'explore' must be \"prove\", or a table as in { engine = \"stateful\", verdict = "
            "\"FAILED\" }",
            "“explore”应为 \"prove\"，或如 { engine = \"stateful\", verdict = \"FAILED\" } 的表"});
    }
  }

  /// Settings that the engine cannot use are errors.
  void CheckWish(const toml::table& wishes, const ExploreWish& wish) {
    if (!wish.follow.empty() && wish.engine != ExploreWish{}.engine) {
      Fail(wishes.get("engine")->source(), DescribeNotFollowed("engine"));
    }
    for (const SearchSetting& setting : SearchSettings()) {
      const toml::node* node = setting.key.empty() ? nullptr : wishes.get(setting.key);
      if (node == nullptr) continue;
      if (!wish.follow.empty()) {
        Fail(node->source(), DescribeNotFollowed(setting.key));
      } else if (!setting.UsedBy(wish.engine)) {
        Fail(node->source(), DescribeUnusedSetting(setting, setting.key, wish.engine));
      }
    }
  }

  static Message DescribeNotFollowed(std::string_view key) {
    return MakeMessage("'{0}' has no effect if only one schedule is followed: remove it",
                       "只跟随一个调度时“{0}”没有意义：应去掉", key);
  }

  void ReadExpectations(const toml::table& table) {
    const toml::node* node = table.get("expect");
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    if (list == nullptr) {
      Fail(node->source(), {"'expect' must be a list of strings, as in [\"sum == 5050\"]",
                            "“expect”应为文本列表，如 [\"sum == 5050\"]"});
      return;
    }
    for (const toml::node& item : *list) {
      const auto text = item.value_exact<std::string>();
      if (!text) {
        Fail(item.source(), {"an expectation must be a string", "期望应为文本"});
        continue;
      }
      auto expectation = ParseExpectation(*text);
      if (!expectation.ok()) {
        Fail(item.source(), expectation.error().message);
        continue;
      }
      expectation.value().place = TextPlaceOf(item.source());
      scenario_.expectations.push_back(std::move(expectation).value());
    }
  }

  const std::string_view text_;
  ScenarioUse use_;
  const gtcalls::CardType* const host_card_;
  Scenario scenario_;
};

}  // namespace

Result<Scenario> ParseScenario(std::string_view text, const std::string& path, ScenarioUse use,
                               TextMargin margin) {
  return ScenarioReader(text, path, use, margin, nullptr).Read();
}

Result<Scenario> LoadScenario(const std::string& path, ScenarioUse use,
                              const gtcalls::CardType* host_card) {
  auto text = ReadFile(path, kScenarioKind);
  if (!text.ok()) return text.error();
  return ScenarioReader(text.value(), path, use, {}, host_card).Read();
}

}  // namespace oncard::runtime
