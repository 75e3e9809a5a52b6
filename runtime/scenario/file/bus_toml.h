// Reads the tables in `ethercat` of a scenario file. Tested by tests/runtime/scenario_bus_test.cc.
#pragma once

#include "runtime/scenario/file/toml_keys.h"
#include "runtime/scenario/world/bus_setup.h"

namespace oncard::runtime {

/// Reads the table `ethercat` for a card with `axis_count` axes; errors are added to `keys`.
BusSetup ReadBus(const toml::table& table, int axis_count, TomlKeys& keys);

}  // namespace oncard::runtime
