// The conditions of a scenario's reactions (`[[world.react]]`, runtime/sim/reactions.h) on a card.
// Tested by tests/runtime/reactions_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/conditions/card_condition.h"
#include "runtime/conditions/program_names.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/scenario_errors.h"
#include "runtime/sim/reactions.h"

namespace oncard::runtime {

class ReactionConditions {
 public:
  explicit ReactionConditions(const World& world);

  /// Which of them hold now, and of which the names exist: those of a program come with it, and can
  /// go.
  Reactions::Look LookAt(const Controller& controller);

 private:
  std::vector<std::string> texts_;
  std::optional<ProgramNames> names_;
  std::vector<std::optional<CardCondition>> conditions_;  ///< empty: names do not exist
};

/// Those whose names exist now.
std::vector<CardCondition> ConditionsOfReactions(const World& world, const Controller& controller);

/// Adds an error for each condition with a name that the card, with its program, does not have now,
/// except for those in `known`, one bit each; `prefix` comes before the reason.
void CheckReactions(const Scenario& scenario, const Controller& controller, uint64_t known,
                    const Message& prefix, ScenarioErrors* errors);

}  // namespace oncard::runtime
