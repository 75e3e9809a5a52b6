#include "runtime/scenario/run/agenda.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "runtime/scenario/run/scenario_start.h"

namespace oncard::runtime {

void Agenda::Read(const Scenario& scenario, Controller* controller, ScenarioErrors* errors) {
  ReadExpectations(scenario, *controller, errors);
  ReadWrites(scenario, controller, errors);
}

void Agenda::ReadExpectations(const Scenario& scenario, const Controller& controller,
                              ScenarioErrors* errors) {
  for (const Expectation& expectation : scenario.expectations) {
    if (!errors->CanJudge(expectation.text())) continue;
    auto bound = CardCondition::Bind(expectation.condition, controller);
    if (!bound.ok()) {
      errors->AddText(expectation.place, expectation.text(), bound.error().message);
      continue;
    }
    for (const Quantity& quantity : bound.value().quantities()) {
      if (quantity.kind == QuantityKind::kThreadError) fault_expected_.push_back(quantity.thread);
    }
    const int64_t cycle = controller.clock().CycleAt(expectation.at_us.value_or(0));
    auto& list = expectation.at_us ? timed_ : at_end_;
    list.push_back({expectation.text(), std::move(bound).value(), cycle});
  }
  std::stable_sort(timed_.begin(), timed_.end(),
                   [](const Check& a, const Check& b) { return a.cycle < b.cycle; });
}

// The writes are prepared now, so that none can fail later.
void Agenda::ReadWrites(const Scenario& scenario, Controller* controller, ScenarioErrors* errors) {
  if (scenario.host.empty()) return;
  const CardClock& clock = controller->clock();
  const ControllerSnapshot before = controller->Snapshot();
  for (const HostEvent& event : scenario.host) {
    for (const InitialValue& written : event.values) {
      if (!errors->CanJudge(written.name)) continue;
      auto variables = SetVariable(written, written.name, controller);
      if (!variables.ok()) {
        errors->Add(written.place, variables.error().message);
        continue;
      }
      for (size_t i = 0; i < written.values.size(); ++i) {
        writes_.push_back({clock.CycleAt(event.at_us), event.after_statements.value_or(kAtEnd),
                           std::move(variables.value()[i]), written.values[i]});
      }
    }
  }
  std::stable_sort(writes_.begin(), writes_.end(), [](const Write& a, const Write& b) {
    return std::tie(a.cycle, a.after_statements) < std::tie(b.cycle, b.after_statements);
  });
  controller->Restore(before);
}

bool Agenda::ExpectsFault(int thread) const {
  return std::ranges::find(fault_expected_, thread) != fault_expected_.end();
}

const Agenda::Check* Agenda::TakeCheck(int64_t cycle) {
  if (!has_checks() || timed_[taken_.check].cycle > cycle) return nullptr;
  return &timed_[taken_.check++];
}

const Agenda::Write* Agenda::TakeWrite(int64_t cycle) {
  if (!has_writes() || next_write().cycle > cycle) return nullptr;
  return &writes_[taken_.write++];
}

const Agenda::Write* Agenda::TakeWriteWithin(int64_t cycle, int64_t executed) {
  return NextWithin(cycle) <= executed ? &writes_[taken_.write++] : nullptr;
}

int64_t Agenda::NextWithin(int64_t cycle) const {
  return has_writes() && next_write().cycle == cycle ? next_write().after_statements : kAtEnd;
}

int64_t Agenda::NextCycle() const {
  const int64_t check = has_checks() ? timed_[taken_.check].cycle : INT64_MAX;
  const int64_t write = has_writes() ? next_write().cycle : INT64_MAX;
  return std::min(check, write);
}

}  // namespace oncard::runtime
