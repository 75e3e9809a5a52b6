// The step that caused a failure, in one sentence: a write over a value that the writer had not
// seen, a decision based on an outdated value, or else the nearest pair of statements that should
// have been executed in the other order. It speaks only of what contributed to the failure
// (relevance.h), and of the threads of the racing pair. Deterministic. Tested by
// tests/explore/failure_test.cc.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/message.h"
#include "explore/engines/failure.h"
#include "explore/reports/trail.h"

namespace oncard::explore {

struct Culprit {
  Message sentence;           ///< steps are numbered from 1
  std::vector<size_t> steps;  ///< the steps that it names, as indices in Trail::steps
};

/// Empty if no step of one thread was executed between steps of another.
std::optional<Culprit> FindCulprit(const Subject& subject, const Failure& failure,
                                   const Trail& trail);

}  // namespace oncard::explore
