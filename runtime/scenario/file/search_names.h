// How scenarios, command lines, search files and reports name what the explorer does. The names of
// one kind stand in the order of the explorer's enum: EngineKind, Verdict
// (explore/search/explorer.h) and RaceRule (explore/models/problem.h).
#pragma once

#include <array>
#include <string_view>

namespace oncard::runtime {

inline constexpr std::array<std::string_view, 7> kEngineNames = {
    "auto", "dpor", "stateful", "bounded", "random", "pct", "pos"};
inline constexpr std::array<std::string_view, 4> kVerdictNames = {"PROVED", "PASSED", "FAILED",
                                                                  "INCOMPLETE"};
/// Of livelocks and deadlocks.
inline constexpr std::array<std::string_view, 2> kHangRuleNames = {"any", "none"};
inline constexpr std::array<std::string_view, 3> kRaceRuleNames = {"any", "benign", "none"};

}  // namespace oncard::runtime
