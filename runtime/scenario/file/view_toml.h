// The table `view` of a scenario file. Tested by tests/runtime/scenario_view_test.cc.
#pragma once

#include "runtime/scenario/file/toml_keys.h"
#include "runtime/scenario/file/view_setup.h"

namespace oncard::runtime {

/// Reads the table of a card with `axis_count` axes; `keys` takes the errors.
ViewSetup ReadView(const toml::table& table, int axis_count, TomlKeys& keys);

}  // namespace oncard::runtime
