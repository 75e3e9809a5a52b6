#include "runtime/scenario/run/reaction_conditions.h"

namespace oncard::runtime {

ReactionConditions::ReactionConditions(const World& world) {
  for (const InputReaction& reaction : world.reactions) texts_.push_back(reaction.when);
}

Reactions::Look ReactionConditions::LookAt(const Controller& controller) {
  if (ProgramNames names = ProgramNames::Of(controller); names_ != names) {
    names_ = std::move(names);
    conditions_.clear();
    for (const std::string& text : texts_) {
      auto bound = CardCondition::Read(text, controller);
      conditions_.push_back(bound.ok() ? std::optional(std::move(bound).value()) : std::nullopt);
    }
  }
  Reactions::Look look;
  uint64_t bit = 1;
  for (const std::optional<CardCondition>& condition : conditions_) {
    if (condition) look.exist |= bit;
    if (condition && condition->Holds(controller)) look.hold |= bit;
    bit <<= 1;
  }
  return look;
}

std::vector<CardCondition> ConditionsOfReactions(const World& world, const Controller& controller) {
  std::vector<CardCondition> conditions;
  for (const InputReaction& reaction : world.reactions) {
    auto bound = CardCondition::Read(reaction.when, controller);
    if (bound.ok()) conditions.push_back(std::move(bound).value());
  }
  return conditions;
}

void CheckReactions(const Scenario& scenario, const Controller& controller, uint64_t known,
                    const Message& prefix, ScenarioErrors* errors) {
  const std::vector<InputReaction>& reactions = scenario.world.reactions;
  for (size_t i = 0; i < reactions.size(); ++i) {
    const std::string& when = reactions[i].when;
    if ((known >> i & 1) != 0 || !errors->CanJudge(when)) continue;
    const auto bound = CardCondition::Read(when, controller);
    if (bound.ok()) continue;
    const Message& why = bound.error().message;
    errors->AddText(PlaceOfText(scenario, kReactionPlaces, i), when,
                    {prefix.en + why.en, prefix.zh + why.zh});
  }
}

}  // namespace oncard::runtime
