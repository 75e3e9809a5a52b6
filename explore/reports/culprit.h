// The step that is to blame for a failure, in one sentence: a write over a value that the writer
// had not seen, a decision on a value that no longer held, or else the nearest pair of statements
// that should have come the other way round.
// Deterministic. Tested by tests/explore/failure_test.cc.
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
  std::vector<size_t> steps;  ///< that it names, indices in Trail::steps
};

/// Empty when no step of one thread has come between those of another.
std::optional<Culprit> FindCulprit(const Subject& subject, const Failure& failure,
                                   const Trail& trail);

}  // namespace oncard::explore
