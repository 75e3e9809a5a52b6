// Which command uses which key of a scenario. No key is read and then left aside in silence: a
// command uses it, or refuses the file.
// Tested by tests/tools/scenario_keys_test.cc, key by key.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/message.h"

namespace oncard::runtime {

/// What a scenario is read for.
enum class ScenarioUse : uint8_t {
  kText,     ///< only to be read: nothing is refused
  kRun,      ///< one run: `oncard run`, `replay`
  kTest,     ///< kExplore when it has the key `explore`, otherwise kRun
  kExplore,  ///< all schedules: `oncard explore`
  kHost      ///< the world of a host program: `oncard exec`
};

enum class KeyUse : uint8_t {
  kUsed,
  kMeansNothing,  ///< there is nothing that it could change: what a picture is called, and so on
  kRefused
};

/// A key of the file itself, with what becomes of it.
struct KeyRule {
  std::string_view name;
  KeyUse run;
  KeyUse explore;
  KeyUse host;
};

/// All keys of the file itself, in the order of the documentation.
std::span<const KeyRule> ScenarioKeyRules();

/// What becomes of a key of ScenarioKeyRules(); `explored` tells whether the file has `explore`.
KeyUse UseOfKey(const KeyRule& rule, ScenarioUse use, bool explored);

/// Why a key is refused, and which command can use it.
Message DescribeRefusedKey(std::string_view key, ScenarioUse use);

/// What bounds or leads a search, and the engines that it means something to.
struct SearchSetting {
  std::string_view key;     ///< of the key `explore`; empty: an option only
  std::string_view option;  ///< of `oncard explore`
  std::span<const std::string_view> engines;

  bool UsedBy(std::string_view engine) const;
};

/// All of them, in the order of the documentation.
std::span<const SearchSetting> SearchSettings();

/// Why an engine cannot be given a setting, which is called `name` where it stands.
Message DescribeUnusedSetting(const SearchSetting& setting, std::string_view name,
                              std::string_view engine);

}  // namespace oncard::runtime
