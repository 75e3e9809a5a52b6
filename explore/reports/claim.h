// What a verdict speaks of, so that it can be filed as evidence: what was asked and what was not,
// of which program, under which assumptions and within which bounds.
//
// Where nothing was asked of results, it says so, shows the different ones, and how to ask for one.
// Texts depend on nothing but their arguments. Tested by tests/explore/claim_test.cc.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "explore/reports/report.h"

namespace oncard::explore {

/// For a terminal: lines with a label each, then the different results; ends in a newline.
std::string ClaimText(const Findings& findings, Language language);

/// The same as a table and a list of a page.
std::string ClaimHtml(const Findings& findings, Language language);

/// Adds `asked` (`requirements`, `faults`, `deadlock`, `livelock`, `limit`, `races`), `program`,
/// `assumptions`, `bounds` and `oncard`, the version; where nothing was asked of results, also
/// `results` and `ask`, a requirement to paste.
void AddClaim(const Findings& findings, nlohmann::ordered_json* json);

}  // namespace oncard::explore
