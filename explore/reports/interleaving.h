// A failing run for pages that draw it themselves: its rows (step_table.h) with their values, the
// statement after which every continuation fails, and from which stale value to which write.
//
// Deterministic. Tested by tests/explore/interleaving_test.cc.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/message.h"
#include "explore/reports/report.h"

namespace oncard::explore {

/// The member `interleaving` of the answer to `explore` (web/README.md). Steps are numbered from 1,
/// as in the texts; `skipped` others come before them.
nlohmann::ordered_json InterleavingJson(const Findings& findings, const Failure& failure,
                                        Language language);

}  // namespace oncard::explore
