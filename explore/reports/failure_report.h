// The part of a report that explains a failing run: what failed, the run statement by statement
// with one column per thread, and the point after which every continuation fails.
//
// Texts depend only on their arguments. Tested by tests/explore/report_test.cc.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "explore/reports/culprit.h"
#include "explore/reports/report.h"
#include "explore/reports/step_table.h"

namespace oncard::explore {

/// "data race: thread 0 reads x in line 3, thread 1 writes it in line 9, and nothing orders them".
Message DescribeRace(const Subject& subject, const Race& race);

/// `final: x == 2 does not hold`.
Message DescribeFault(const Findings& findings, const Failure& failure);

/// `final: x == 2 does not hold: x is 1, expected 2`.
Message WhatFailed(const Findings& findings, const Failure& failure);

/// The table of a failing run, with what its texts name. The findings must outlive it.
StepView ViewOf(const Findings& findings, const Failure& failure,
                const std::optional<Culprit>& culprit, Detail detail);
/// That of the steps that then repeat for ever.
StepView CycleOf(const Findings& findings, Detail detail);

/// For a terminal; ends in a newline.
std::string FailureText(const Findings& findings, const Failure& failure,
                        const ReportOptions& options, Language language);

/// Paragraphs and tables of an HTML page.
std::string FailureHtml(const Findings& findings, const Failure& failure,
                        const ReportOptions& options, Language language);

/// `what` both access, and the two `statements`.
nlohmann::ordered_json RaceJson(const Subject& subject, const Race& race);

/// Adds `reason`, `actual`, `culprit`, the `orders` of a data race, the counts of the failing run,
/// its `racing_pair` and its `schedule`.
void AddFailure(const Findings& findings, const Failure& failure, nlohmann::ordered_json* json);

}  // namespace oncard::explore
