// How the machine of a scenario looks to a reader. Nothing of a run depends on it. Source:
// assumption, see docs/scenarios.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace oncard::runtime {

/// What a machine can look like.
inline constexpr std::string_view kMachineKinds[] = {"auto",   "stages",  "xy",
                                                     "rotary", "gripper", "conveyor"};

/// A pin that the machine names, for example a lamp or a button.
struct ViewPin {
  std::string type = "gpi";  ///< the word of the pin: `gpi`, `gpo`, `home` ...
  int index = 0;             ///< from 1
  std::string name;
  std::string name_zh;  ///< empty: `name` serves both languages

  bool operator==(const ViewPin&) const = default;
};

struct ViewSetup {
  std::string title;
  std::string title_zh;       ///< empty: `title` serves both languages
  std::string kind = "auto";  ///< of kMachineKinds
  // Axes from 1; 0: none. A kind that has one moving part looks at `x` alone.
  int x = 1;
  int y = 2;
  int z = 0;
  /// How far the axis of a rotary table goes in a turn, in its unit.
  double turn = 10000;
  std::vector<ViewPin> pins;

  bool operator==(const ViewSetup&) const = default;
};

}  // namespace oncard::runtime
