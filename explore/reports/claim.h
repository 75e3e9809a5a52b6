// The scope of a verdict, so that it can be kept as evidence: what was checked and what was not,
// for which program, under which assumptions and within which bounds.
//
// If there were no requirements on results, it says so, shows the different results, and how to
// require one of them. Texts depend only on their arguments. Tested by tests/explore/claim_test.cc.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "explore/reports/report.h"

namespace oncard::explore {

/// Its parts, line by line; a part without lines has nothing to say.
struct Claim {
  std::vector<Message> requirements;  ///< as they were written
  std::vector<Message> built_in;      ///< what was asked without a requirement
  std::vector<Message> not_asked;
  std::vector<Message> program;  ///< with the hashes of what was searched
  std::vector<Message> cases;    ///< of a scenario with choices
  std::vector<Message> covered;  ///< of each choice the values that were covered
  std::vector<Message> assumptions;
  std::vector<Message> bounds;
  Message by;  ///< version and engine
};
Claim ClaimOf(const Findings& findings);

/// Results that nobody has asked for.
struct UnaskedResults {
  Message head;                   ///< how many were found
  std::vector<std::string> ends;  ///< `next = 2, ret0 = 1`
  Message ask;                    ///< where to require one of them
  std::string requirement;        ///< the line to be pasted there; empty if there is none
};

/// Empty if there are requirements, or a failure, and for an endless program.
std::optional<UnaskedResults> UnaskedResultsOf(const Findings& findings);

/// For a terminal: labelled lines, then the different results; ends in a newline.
std::string ClaimText(const Findings& findings, Language language);

/// Adds `asked` (`requirements`, `faults`, `endless` of such a program, `deadlock`, `livelock`,
/// `limit`, `races`), `program`, of a scenario with choices `choices`, `cases`,
/// `cases_searched` and `covered`, of each choice the number of its `values` that were `covered`,
/// `assumptions`, `bounds` and `oncard`, the version; if there were no requirements on results,
/// also `results` and `ask`, a requirement to paste; of an incomplete search `reached`, `spent_on`
/// and `try` (way_out.h).
void AddClaim(const Findings& findings, nlohmann::ordered_json* json);

}  // namespace oncard::explore
