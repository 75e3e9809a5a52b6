#include "runtime/scenario/run/scenario_card.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <utility>

#include "gtcalls/families.h"
#include "runtime/scenario/run/reaction_conditions.h"
#include "runtime/scenario/world/world_events.h"

namespace oncard::runtime {

const gtcalls::Family& FamilyOf(const Scenario& scenario) {
  const auto card = gtcalls::FindCard(scenario.card);
  return card ? *card->family : *gtcalls::Families().front();
}

ControllerOptions CardOptions(const Scenario& scenario) {
  ControllerOptions options;
  options.family = &FamilyOf(scenario);
  if (const auto card = gtcalls::FindCard(scenario.card)) options.type = card->type;
  options.motion.axis_count = scenario.axis_count;
  options.motion.cycle_us = scenario.cycle_us;
  options.rate = scenario.rate;
  for (const MotorSetup& motor : scenario.world.motors) {
    options.units[static_cast<size_t>(motor.axis - 1)] = UnitOf(scenario.world, motor.axis);
  }
  return options;
}

void ApplyWorld(const Scenario& scenario, Controller* controller) {
  motion::MotionCore& core = controller->motion();
  const CardClock& clock = controller->clock();
  SetUpWorld(scenario.world, scenario.bus, clock, core);
  controller->card().bus_error = scenario.bus.eni_error;
  if (!scenario.memory.empty()) {
    // Who has read it from a file or a record has checked it.
    [[maybe_unused]] const auto restored = controller->family().restore_memory(
        scenario.memory, scenario.mram, controller->card().family_state);
    assert(restored.ok());
  }
  core.PowerOn(
      std::make_shared<const motion::WorldEvents>(EventsOf(scenario.world, scenario.bus, clock)));
  if (!scenario.world.reactions.empty()) {
    auto look = [controller, conditions = ReactionConditions(scenario.world)]() mutable {
      return conditions.LookAt(*controller);
    };
    controller->LetWorldReact({ReactionsOf(scenario.world), std::move(look)});
  }
  if (controller->family().cycle_ns == 0) return;
  controller->ListenToClock([world = scenario.world, bus = scenario.bus, &clock, &core] {
    FollowClock(world, bus, clock, core);
  });
}

bool NeedsCard(const Scenario& scenario, const vm::Object& object) {
  const auto calls = [](const vm::Function& function) {
    return std::ranges::any_of(function.instructions, [](const vm::Instruction& instruction) {
      return instruction.opcode == vm::Opcode::kCommand;
    });
  };
  return scenario.until_us || std::ranges::any_of(object.functions, calls) ||
         std::ranges::any_of(scenario.threads,
                             [](const auto& thread) { return thread.period_ms != 0; }) ||
         std::ranges::any_of(scenario.expectations, [](const auto& expectation) {
           return expectation.at_us.has_value() || expectation.condition.HasTolerance();
         });
}

}  // namespace oncard::runtime
