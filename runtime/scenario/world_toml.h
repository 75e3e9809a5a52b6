// Reads the tables below `world` of a scenario file.
// Tested by tests/runtime/scenario_world_test.cc.
#pragma once

#include "runtime/scenario/toml_keys.h"
#include "runtime/scenario/world_setup.h"

namespace oncard::runtime {

/// Reads the table `world` for a card of so many axes; errors go to `keys`.
World ReadWorld(const toml::table& table, int axis_count, TomlKeys& keys);

}  // namespace oncard::runtime
