// Which statements of a failing run have contributed to the failure: those that wrote what the
// failed requirement names, those whose values they used, and the decisions that led their threads
// there (a dynamic slice: Korel and Laski, Dynamic program slicing, 1988). A write
// that changes nothing does not hide the ones before it. Deterministic. Tested by
// tests/explore/failure_test.cc.
#pragma once

#include <vector>

#include "explore/engines/failure.h"
#include "explore/reports/trail.h"

namespace oncard::explore {

/// For every step of a trail that has led the controller to where it is. If the requirement names
/// the card or the error of a thread, every GT command contributes; if the failure is not that of a
/// requirement or of a thread, every step does.
std::vector<bool> StepsThatMatter(const Subject& subject, const Failure& failure,
                                  const runtime::Controller& controller,
                                  const std::vector<TrailStep>& steps);

}  // namespace oncard::explore
