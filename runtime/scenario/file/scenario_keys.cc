#include "runtime/scenario/file/scenario_keys.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "runtime/scenario/file/key_table.h"

namespace oncard::runtime {
namespace {

constexpr std::string_view kOfTraces[] = {"auto", "dpor"};
constexpr std::string_view kOfStates[] = {"auto", "stateful", "bounded"};
constexpr std::string_view kOfAuto[] = {"auto"};
constexpr std::string_view kOfGraphs[] = {"auto", "stateful"};
constexpr std::string_view kOfRandom[] = {"random", "pct", "pos"};
constexpr std::string_view kOfPct[] = {"pct"};
constexpr std::string_view kOfBounded[] = {"bounded"};

constexpr SearchSetting kSettings[] = {
    {"max_executions", "--max-executions", kOfTraces},
    {"max_states", "--max-states", kOfStates},
    {"runs", "--runs", kOfRandom},
    {"", "--seed", kOfRandom},
    {"", "--depth", kOfPct},
    {"", "--preemptions", kOfBounded},
    {"", "--merge-private", kOfGraphs},
    {"", "--no-merge-private", kOfGraphs},
    {"", "--no-dead-locals", kOfGraphs},
    {"", "--no-symmetry", kOfGraphs},
    {"", "--no-islands", kOfAuto},
    {"", "--no-reductions", kOfAuto},
};

}  // namespace

bool SearchSetting::UsedBy(std::string_view engine) const {
  return std::ranges::find(engines, engine) != engines.end();
}

std::span<const SearchSetting> SearchSettings() { return kSettings; }

Message DescribeUnusedSetting(const SearchSetting& setting, std::string_view name,
                              std::string_view engine) {
  return MakeMessage("'{0}' has no effect with the engine {1}: remove it, or use {2}",
                     "“{0}”对 {1} 引擎没有意义：应去掉，或使用 {3}", name, engine,
                     fmt::join(setting.engines, ", "), fmt::join(setting.engines, "、"));
}

std::span<const KeyRule> ScenarioKeyRules() {
  // Never destroyed: it is used while a host exits.
  static const auto& rules = *new const std::vector<KeyRule>([] {
    std::vector<KeyRule> all;
    for (const Key<Scenario>& key : ScenarioKeys()) {
      const KeyUses& uses = key.about.uses;
      all.push_back({key.about.name, uses.run, uses.explore, uses.host});
    }
    return all;
  }());
  return rules;
}

KeyUse UseOfKey(const KeyRule& rule, ScenarioUse use, bool explored) {
  switch (use) {
    case ScenarioUse::kText:
      return KeyUse::kUsed;
    case ScenarioUse::kRun:
      return rule.run;
    case ScenarioUse::kSession:
      return rule.run == KeyUse::kRefused ? rule.explore : rule.run;
    case ScenarioUse::kTest:
      return explored ? rule.explore : rule.run;
    case ScenarioUse::kExplore:
      return rule.explore;
    case ScenarioUse::kHost:
      break;
  }
  return rule.host;
}

Message DescribeRefusedHostProgram() {
  return {
      "'host' names a host program, which only 'oncard test' and 'oncard exec' run: give this "
      "command a motion program",
      "“host”给出的是主机程序，只有“oncard test”和“oncard exec”能运行；此命令需要运动程序"};
}

Message DescribeRefusedKey(std::string_view key, ScenarioUse use) {
  if (use == ScenarioUse::kHost) {
    return MakeMessage(
        "'{0}' cannot be used with a host program: 'oncard exec' takes the card, its world and "
        "what must hold from a scenario; remove it",
        "“{0}”不能用于主机程序：“oncard exec”只从场景读取控制卡、外部世界与应成立的条件；"
        "应去掉",
        key);
  }
  if (key == "keys") {
    return {"'keys' are pressed for a host program: only 'oncard exec' can use them; remove them",
            "“keys”供主机程序使用：只有“oncard exec”能使用；应去掉"};
  }
  if (key == "mram") {
    return {
        "'mram' is for a host program, only hosts can read and write this memory: only 'oncard "
        "exec' can use it; remove it",
        "“mram”供主机程序使用，只有主机能读写该存储器：只有“oncard exec”能使用；应去掉"};
  }
  if (key == "host") {
    return {
        "a scenario with [[host]] cannot be explored: start the threads with the values that the "
        "host would write",
        "带 [[host]] 的场景无法探索：应在启动线程时就给出主机要写入的值"};
  }
  return MakeMessage(
      "'{0}' concerns all schedules, a single run cannot check it: use 'oncard explore', or add "
      "the key 'explore' to the file for 'oncard test'",
      "“{0}”针对所有调度，单次运行无法检查：请用“oncard explore”，或为“oncard test”"
      "在文件中加上“explore”",
      key);
}

}  // namespace oncard::runtime
