// Reads the tables in `world` of a scenario file.
// Tested by tests/runtime/scenario_world_test.cc.
#pragma once

#include <vector>

#include "runtime/scenario/file/placed_errors.h"
#include "runtime/scenario/file/toml_keys.h"
#include "runtime/scenario/world/world_setup.h"

namespace oncard::runtime {

/// The places of what a world is checked for later, each list in the order of the world's own.
struct WorldPlaces {
  std::vector<TextPlace> conditions;  ///< of World::reactions
  std::vector<TextPlace> inputs;      ///< of what is open in them, otherwise of the tables
  std::vector<TextPlace> faults;
};

/// Reads the table `world` for a card with `axis_count` axes; errors are added to `keys`.
World ReadWorld(const toml::table& table, int axis_count, TomlKeys& keys, WorldPlaces* places);

}  // namespace oncard::runtime
