// Reads the tables in `world` of a scenario file.
// Tested by tests/runtime/scenario_world_test.cc.
#pragma once

#include "runtime/scenario/file/toml_keys.h"
#include "runtime/scenario/world/world_setup.h"

namespace oncard::runtime {

/// Reads the table `world` for a card with `axis_count` axes; errors are added to `keys`.
World ReadWorld(const toml::table& table, int axis_count, TomlKeys& keys);

}  // namespace oncard::runtime
