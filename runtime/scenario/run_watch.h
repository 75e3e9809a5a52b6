// Whoever looks at a run from outside while it goes on.
#pragma once

#include <vector>

#include "base/result.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

class RunWatch {
 public:
  RunWatch() = default;
  RunWatch(const RunWatch&) = delete;
  RunWatch& operator=(const RunWatch&) = delete;
  virtual ~RunWatch() = default;

  /// The card before the first statement. Fails when what shall be looked at is not there.
  virtual Result<void> Begin(const Controller& controller) = 0;
  /// True when Look() is wanted; a run whose every state is looked at is slower.
  virtual bool LooksAtStates() const = 0;
  /// A state: the first, and then the one after every statement and every beginning of a cycle.
  virtual void Look(const Controller& controller) = 0;
  /// The run has come to an end that is judged.
  virtual void End(const Controller& controller) = 0;
};

}  // namespace oncard::runtime
