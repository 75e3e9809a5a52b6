// Reads the tables in `world` of a scenario file.
// Tested by tests/runtime/scenario_world_test.cc.
#pragma once

#include <vector>

#include "runtime/scenario/file/placed_errors.h"
#include "runtime/scenario/file/toml_keys.h"
#include "runtime/scenario/world/world_setup.h"

namespace oncard::runtime {

/// Reads the table `world` for a card with `axis_count` axes; errors are added to `keys`, the
/// places of the conditions of World::reactions to `conditions`.
World ReadWorld(const toml::table& table, int axis_count, TomlKeys& keys,
                std::vector<TextPlace>* conditions);

}  // namespace oncard::runtime
