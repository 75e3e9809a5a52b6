// How a scenario fits its program: what it says of functions, variables and other names that the
// program does not have, all of it at once and each with its place.
// Tested by tests/runtime/scenario_fit_test.cc.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/placed_errors.h"
#include "runtime/scenario/scenario.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

class ScenarioFit {
 public:
  /// What stands in a place does not fit.
  void Add(const TextPlace& place, Message why) { clashes_.Add(place, std::move(why)); }
  /// The same of a text; one that stands nowhere is quoted.
  void AddText(const TextPlace& place, std::string_view text, const Message& why);
  /// A thread is not bound, which has been added: what is wrong with the names of threads and pages
  /// follows from that.
  void MissThread() { all_bound_ = false; }
  /// False for a text with such a name while a thread is missing: it is not to be judged.
  bool CanJudge(std::string_view text) const;
  /// Everything that does not fit; empty when all does.
  std::optional<Error> Failure() const { return clashes_.Failure(); }

 private:
  PlacedErrors clashes_;
  bool all_bound_ = true;
};

/// What the names of a scenario's `trace` stand for; adds those that stand for nothing.
std::vector<Quantity> TraceQuantities(const Scenario& scenario, const Controller& controller,
                                      ScenarioFit* fit);

}  // namespace oncard::runtime
