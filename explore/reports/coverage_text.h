// What a search has executed of its program, function by function, for a page that is filed.
//
// A line counts as reached if one of its instructions was executed. A jump or a return with a
// condition can go two ways. Texts depend only on their arguments. Tested by
// tests/explore/coverage_text_test.cc.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/message.h"
#include "explore/reports/report.h"

namespace oncard::explore {

/// What was executed of a line of the source.
enum class LineMark : uint8_t {
  kNone,    ///< it has no statement of a thread
  kMissed,  ///< it was not reached
  kReached,
  kOneWay  ///< it was reached, and a condition in it went one way
};

/// Of each line of the program's text; empty if the text is unknown, or what was executed.
std::vector<LineMark> MarksOf(const Findings& findings);

/// One line for each function of a thread, and one that says what its figures mean. Only of a proof
/// it says that a line cannot be reached.
std::vector<Message> DescribeCoverage(const Findings& findings);

/// The same as `coverage`, an array with `function`, `lines`, `lines_reached`, `ways`, `ways_gone`,
/// and the numbers of lines `not_reached` and `one_way`. Nothing if the search did not note it.
void AddCoverage(const Findings& findings, nlohmann::ordered_json* json);

}  // namespace oncard::explore
