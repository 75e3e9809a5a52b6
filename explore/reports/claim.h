// The scope of a verdict, so that it can be kept as evidence: what was checked and what was not,
// for which program, under which assumptions and within which bounds.
//
// If there were no requirements on results, it says so, shows the different results, and how to
// require one of them. Texts depend only on their arguments. Tested by tests/explore/claim_test.cc.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "explore/reports/report.h"

namespace oncard::explore {

/// For a terminal: labelled lines, then the different results; ends in a newline.
std::string ClaimText(const Findings& findings, Language language);

/// The same as a table and a list for an HTML page, with what was executed (coverage_text.h).
std::string ClaimHtml(const Findings& findings, Language language);

/// Adds `asked` (`requirements`, `faults`, `endless` of such a program, `deadlock`, `livelock`,
/// `limit`, `races`), `program`, of a scenario with choices `choices`, `cases` and
/// `cases_searched`, `assumptions`, `bounds` and `oncard`, the version; if there were no
/// requirements on results, also `results` and `ask`, a requirement to paste; of
/// an incomplete search `reached`, `spent_on` and `try` (way_out.h).
void AddClaim(const Findings& findings, nlohmann::ordered_json* json);

}  // namespace oncard::explore
