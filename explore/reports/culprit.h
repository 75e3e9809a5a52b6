// The step that caused a failure, in one sentence: a write over a value that the writer had not
// seen, a decision based on an outdated value, or else the nearest pair of statements that should
// have been executed in the other order. It speaks only of what contributed to the failure
// (relevance.h), and of the threads of the racing pair. Deterministic. Tested by
// tests/explore/failure_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "explore/engines/failure.h"
#include "explore/reports/trail.h"

namespace oncard::explore {

/// A thread has used at `use` the value that it read at `read`, although another thread changed it
/// at `write`; all three are indices in Trail::steps.
struct StaleValue {
  enum class Kind : uint8_t { kOverwrites, kComputes, kDecides };
  Kind kind = Kind::kOverwrites;
  std::string name;     ///< of the variable
  std::string value;    ///< what was read
  std::string changed;  ///< what the other thread has written
  size_t read = 0;
  size_t write = 0;
  size_t use = 0;
};

struct Culprit {
  Message sentence;                      ///< steps are numbered from 1
  std::vector<size_t> steps;             ///< the steps that it names, as indices in Trail::steps
  std::optional<StaleValue> stale = {};  ///< empty: two statements whose order makes the difference
};

/// Empty if no step of one thread was executed between steps of another.
std::optional<Culprit> FindCulprit(const Subject& subject, const Failure& failure,
                                   const Trail& trail);

}  // namespace oncard::explore
