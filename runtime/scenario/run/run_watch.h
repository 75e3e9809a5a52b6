// An observer of a run.
#pragma once

#include <vector>

#include "runtime/scenario/run/scenario_errors.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

class RunWatch {
 public:
  RunWatch() = default;
  RunWatch(const RunWatch&) = delete;
  RunWatch& operator=(const RunWatch&) = delete;
  virtual ~RunWatch() = default;

  /// Called before the first statement. Adds an error to `errors` for everything that it should
  /// observe and that does not exist; then no other function is called.
  virtual void Begin(const Controller& controller, ScenarioErrors* errors) = 0;
  /// True if ObserveState() is to be called; observing every state makes a run slower.
  virtual bool ObservesStates() const = 0;
  /// Called in the first state, and then after every statement and every beginning of a cycle.
  virtual void ObserveState(const Controller& controller) = 0;
  /// Called at the end of a run whose requirements are to be checked.
  virtual void End(const Controller& controller) = 0;
};

}  // namespace oncard::runtime
