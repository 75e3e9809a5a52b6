// Which command uses which key of a scenario. No key is silently ignored: a command either uses it
// or rejects the file. Tested by tests/tools/scenario_keys_test.cc, key by key.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/message.h"

namespace oncard::runtime {

/// The purpose for which a scenario is read.
enum class ScenarioUse : uint8_t {
  kText,     ///< only reading: nothing is rejected
  kRun,      ///< one run: `oncard run`, `replay`
  kSession,  ///< a run that a user drives (`session/`), also of a scenario for the explorer
  kTest,     ///< kHost if it has a host program, kExplore if it has `explore`, otherwise kRun
  kExplore,  ///< all schedules: `oncard explore`
  kHost      ///< the card and surroundings of a host program: `oncard exec`
};

enum class KeyUse : uint8_t {
  kUsed,
  kMeansNothing,  ///< it has no effect here, such as the title of a picture
  kRefused
};

/// A top-level key, and how each command treats it.
struct KeyRule {
  std::string_view name;
  KeyUse run;
  KeyUse explore;
  KeyUse host;
};

/// All top-level keys, in the order of the documentation.
std::span<const KeyRule> ScenarioKeyRules();

/// How a key of ScenarioKeyRules() is treated; `explored`: the file has `explore`.
KeyUse UseOfKey(const KeyRule& rule, ScenarioUse use, bool explored);

/// Why the table `host` is rejected, which names a host program.
Message DescribeRefusedHostProgram();

/// Why a key is rejected, and which command can use it.
Message DescribeRefusedKey(std::string_view key, ScenarioUse use);

/// A setting of a search, and the engines that it applies to.
struct SearchSetting {
  std::string_view key;     ///< name in the key `explore`; empty: an option only
  std::string_view option;  ///< of `oncard explore`
  std::span<const std::string_view> engines;

  bool UsedBy(std::string_view engine) const;
};

/// The largest values of settings, in scenarios and elsewhere.
inline constexpr int64_t kSearchCountMax = 1'000'000'000'000;  ///< executions, runs
inline constexpr uint32_t kSearchStatesMax = 4'000'000'000;
inline constexpr int kPreemptionsMax = 1000;

/// All of them, in the order of the documentation.
std::span<const SearchSetting> SearchSettings();

/// Why an engine does not accept a setting, which is called `name` in the input.
Message DescribeUnusedSetting(const SearchSetting& setting, std::string_view name,
                              std::string_view engine);

}  // namespace oncard::runtime
