#include "runtime/scenario_world.h"

#include <algorithm>
#include <memory>

namespace oncard::runtime {
namespace {

using motion::WorldEvent;
using motion::WorldEventKind;
using motion::WorldEvents;

void AddInput(const InputEvent& input, WorldEvents& events) {
  for (int bit = 0; bit < motion::DiWidth(input.type); ++bit) {
    if (input.index != 0 && input.index != bit + 1) continue;
    const uint32_t level = input.index == 0 ? input.value >> bit & 1 : input.value;
    events.push_back({.at = input.at_us,
                      .kind = WorldEventKind::kPin,
                      .item = static_cast<uint8_t>(input.type),
                      .index = static_cast<uint16_t>(bit),
                      .value = static_cast<double>(level)});
  }
}

}  // namespace

ControllerOptions CardOptions(const Scenario& scenario) {
  ControllerOptions options;
  options.motion.cycle_us = scenario.cycle_us;
  options.rate = scenario.rate;
  return options;
}

void ApplyWorld(const Scenario& scenario, Controller* controller) {
  WorldEvents events;
  for (const InputEvent& input : scenario.inputs) AddInput(input, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const WorldEvent& a, const WorldEvent& b) { return a.at < b.at; });
  controller->motion().SetWorld(std::make_shared<const WorldEvents>(std::move(events)));
}

}  // namespace oncard::runtime
