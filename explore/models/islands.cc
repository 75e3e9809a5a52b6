#include "explore/models/islands.h"

#include <algorithm>
#include <bit>
#include <string>
#include <string_view>
#include <utility>

#include "base/trim.h"
#include "explore/models/added_globals.h"
#include "runtime/scenario/run/vacuity.h"
#include "vm/arithmetic.h"

namespace oncard::explore {
namespace {

using gtcalls::Resource;
using runtime::StatementAccess;
using runtime::Touched;

/// The run that shows which threads share something ends after so many statements. What it does not
/// show the search of the islands finds.
constexpr int64_t kWatchedStatements = 100'000;

constexpr int64_t kUsPerMs = 1000;

bool CanHaveIslands(const CardModel& model) {
  const runtime::Scenario& scenario = model.scenario();
  if (model.thread_count() < 2 || model.host() != nullptr) return false;
  if (!scenario.world.reactions.empty() || scenario.bus != runtime::BusSetup{}) return false;
  if (runtime::MayLastForEver(scenario) && !scenario.until_us) return false;
  // The switch of one axis may stop another one.
  for (const runtime::SwitchSetup& contact : scenario.world.switches) {
    if (contact.type != motion::DiType::kGpi && contact.index != contact.axis) return false;
  }
  if (std::ranges::any_of(scenario.threads,
                          [](const runtime::ThreadStart& start) { return start.period_ms != 0; })) {
    return false;
  }
  if (scenario.rate * scenario.cycle_us / kUsPerMs < model.thread_count()) return false;
  return !runtime::WaitsForVariables(model.image()->object, model.controller().family().catalogue);
}

/// The parts of a text between operators that stand outside of parentheses.
std::vector<std::string> SplitAt(std::string_view text, std::string_view op) {
  std::vector<std::string> parts;
  size_t begin = 0;
  int depth = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (depth != 0 || text.substr(i, op.size()) != op) continue;
    parts.emplace_back(text.substr(begin, i - begin));
    i += op.size() - 1;
    begin = i + 1;
  }
  parts.emplace_back(text.substr(begin));
  return parts;
}

/// The texts that must all hold where the text must hold; that must all not hold under `never`.
std::vector<std::string> PartsOf(Scope scope, std::string_view text) {
  std::vector<std::string> alternatives = SplitAt(text, "||");
  if (scope == Scope::kNever) return alternatives;
  const bool splits =
      (scope == Scope::kFinal || scope == Scope::kAlways) && alternatives.size() == 1;
  return splits ? SplitAt(text, "&&") : std::vector<std::string>{std::string(text)};
}

}  // namespace

std::optional<Islands> Islands::Of(const CardModel& whole) {
  if (!CanHaveIslands(whole)) return std::nullopt;
  // What the model has noted of its runs stays as it is.
  runtime::Scenario scenario = whole.scenario();
  scenario.expectations.clear();
  auto watched = CardModel::Create(scenario, {}, whole.image()->object);
  if (!watched.ok()) return std::nullopt;
  Islands islands;
  for (int i = 0; i < whole.thread_count(); ++i) {
    const ThreadSetup& setup = whole.setup(i);
    islands.islands_.push_back({uint32_t{1} << i,
                                {{Resource::kProgram, static_cast<uint32_t>(setup.thread), true},
                                 {Resource::kThread, static_cast<uint32_t>(setup.page), true}}});
  }
  if (!islands.ReadParts(whole)) return std::nullopt;
  islands.FindSums(whole);
  islands.Watch(&watched.value());
  if (!islands.AddAsserts(whole)) return std::nullopt;
  islands.AssignParts();
  islands.Join();
  if (islands.islands_.size() < 2) return std::nullopt;
  return islands;
}

void Islands::Watch(CardModel* model) {
  CardModel::State state = model->Begin();
  for (int64_t i = 0; i < kWatchedStatements && !state.ended; ++i) {
    const int thread = std::countr_zero(state.choices);
    AddAccesses(runtime::NextLastingAccess(model->controller(), model->setup(thread).thread),
                static_cast<size_t>(thread));
    model->Advance(&state, thread);
  }
}

bool Islands::AddAsserts(const CardModel& whole) {
  const vm::Object& object = whole.image()->object;
  for (int i = 0; i < whole.thread_count(); ++i) {
    const ThreadSetup& setup = whole.setup(i);
    for (const vm::Assert& assert : object.functions[static_cast<size_t>(setup.function)].asserts) {
      const auto access = whole.AccessOfAssert(i, assert);
      if (!access) return false;
      AddAccesses(*access, static_cast<size_t>(i));
    }
  }
  return true;
}

bool Islands::ReadParts(const CardModel& whole) {
  const std::vector<runtime::Expectation>& expectations = whole.scenario().expectations;
  const std::vector<Requirement> requirements = whole.Requirements();
  for (size_t i = 0; i < requirements.size() && requirements[i].scope != Scope::kAssert; ++i) {
    const Requirement& requirement = requirements[i];
    const size_t instant = std::min(requirement.text.find('@'), requirement.text.size());
    std::vector<std::string> texts =
        PartsOf(requirement.scope, std::string_view(requirement.text).substr(0, instant));
    // Where its right side matters is asked of the whole.
    if (runtime::GuardOf(requirement)) texts = {requirement.text.substr(0, instant)};
    for (const std::string& text : texts) {
      Part part = {.origin = i, .requirement = requirement};
      part.requirement.text = Trim(text);
      if (i < expectations.size()) {
        auto expectation = runtime::ParseExpectation(text + requirement.text.substr(instant));
        if (!expectation.ok()) return false;
        part.expectation = std::move(expectation).value();
      }
      if (!ReadPart(std::move(part), whole)) return false;
    }
  }
  return true;
}

bool Islands::ReadPart(Part part, const CardModel& whole) {
  part.lasts = part.requirement.scope == Scope::kWithin;
  for (const std::string* side : {&part.requirement.text, &part.requirement.then}) {
    if (side->empty()) continue;
    auto bound = runtime::CardCondition::Read(*side, whole.controller());
    if (!bound.ok()) return false;
    for (const runtime::Quantity& quantity : bound.value().quantities()) {
      part.lasts = part.lasts || !runtime::IsOfProgram(quantity.kind);
      runtime::AddAccesses(runtime::LastingAccessOf(quantity, whole.controller()), &part.reads);
    }
    const bool has_instant = part.expectation && part.expectation->at_us;
    // Whether the right side of an implication has mattered is noted in a run.
    if (part.requirement.scope == Scope::kFinal && !has_instant &&
        !runtime::GuardOf(part.requirement)) {
      part.at_end = std::move(bound).value();
    }
  }
  parts_.push_back(std::move(part));
  return true;
}

void Islands::FindSums(const CardModel& whole) {
  // Threads that add to one variable race for it.
  if (whole.scenario().races != "any") return;
  only_added_ = GlobalsOnlyAddedTo(whole.image()->object, whole.setups());
  const auto drop = [&](const StatementAccess& accesses) {
    return std::erase_if(only_added_, [&](uint16_t slot) {
             return runtime::FindDependence({{Resource::kVariable, slot, true}}, accesses) !=
                    nullptr;
           }) > 0;
  };
  for (int i = 0; i < whole.thread_count(); ++i) {
    const ThreadSetup& setup = whole.setup(i);
    const auto function = static_cast<size_t>(setup.function);
    for (const vm::Assert& assert : whole.image()->object.functions[function].asserts) {
      if (const auto access = whole.AccessOfAssert(i, assert)) drop(*access);
    }
  }
  const auto asks_of_sums = [&](const Part& part) {
    return part.at_end && !part.reads.empty() && WithoutGlobals(only_added_, part.reads).empty();
  };
  // What is compared with something else is no sum, which can make another one something else.
  while (std::ranges::any_of(
      parts_, [&](const Part& part) { return !asks_of_sums(part) && drop(part.reads); })) {
  }
  std::erase_if(parts_, [&](Part& part) {
    if (!asks_of_sums(part)) return false;
    for (const Touched& touched : part.reads) {
      summed_.push_back(static_cast<uint16_t>(touched.number));
    }
    asked_of_sums_.push_back(*std::move(part.at_end));
    return true;
  });
  std::ranges::sort(summed_);
  summed_.erase(std::unique(summed_.begin(), summed_.end()), summed_.end());
}

bool Islands::HoldsWith(const GlobalSums& values) const {
  return std::ranges::all_of(asked_of_sums_, [&](const runtime::CardCondition& asked) {
    return asked.condition().Holds([&](size_t name) {
      const auto place = std::ranges::lower_bound(summed_, asked.quantities()[name].slot.id);
      return vm::ToInt(values[static_cast<size_t>(place - summed_.begin())]);
    });
  });
}

void Islands::AssignParts() {
  for (Part& part : parts_) {
    // All that set something which it names are then found to be one island.
    for (const Island& island : islands_) {
      if (runtime::FindDependence(island.accesses, part.reads) == nullptr) continue;
      part.thread = std::countr_zero(island.threads);
      break;
    }
    runtime::AddAccesses(part.reads, &islands_[IslandOf(part.thread)].accesses);
  }
}

void Islands::AddAccesses(const StatementAccess& accesses, size_t island) {
  runtime::AddAccesses(WithoutGlobals(only_added_, accesses), &islands_[island].accesses);
}

size_t Islands::IslandOf(int thread) const {
  size_t island = 0;
  while ((islands_[island].threads >> thread & 1) == 0) ++island;
  return island;
}

bool Islands::Add(size_t island, const StatementAccess& accesses) {
  AddAccesses(accesses, island);
  return Join();
}

bool Islands::Join() {
  bool joined = false;
  for (size_t one = 1; one < islands_.size(); ++one) {
    for (size_t other = 0; other < one; ++other) {
      if (runtime::FindDependence(islands_[one].accesses, islands_[other].accesses) == nullptr) {
        continue;
      }
      islands_[other].threads |= islands_[one].threads;
      runtime::AddAccesses(islands_[one].accesses, &islands_[other].accesses);
      islands_.erase(islands_.begin() + static_cast<std::ptrdiff_t>(one));
      joined = true;
      // Those that have been compared may depend on what is one island now.
      one = 0;
      break;
    }
  }
  return joined;
}

std::optional<IslandCard> Islands::Build(size_t island, const CardModel& whole) const {
  runtime::Scenario scenario = whole.scenario();
  std::erase_if(scenario.threads, [&](const runtime::ThreadStart& start) {
    for (int i = 0; i < whole.thread_count(); ++i) {
      const bool inside = (islands_[island].threads >> i & 1) != 0;
      if (inside && whole.setup(i).thread == start.thread) return false;
    }
    return true;
  });
  scenario.trace.clear();
  scenario.expectations.clear();
  std::vector<Requirement> requirements;
  std::vector<size_t> origins;
  bool lasts = false;
  for (const Part& part : parts_) {
    if (IslandOf(part.thread) != island) continue;
    if (part.expectation) {
      scenario.expectations.push_back(*part.expectation);
    } else {
      requirements.push_back(part.requirement);
    }
    origins.push_back(part.origin);
    lasts = lasts || part.lasts;
  }
  auto model = CardModel::Create(scenario, requirements, whole.image()->object);
  if (!model.ok()) return std::nullopt;
  model.value().RunBeside(whole);
  return IslandCard{std::move(model).value(), std::move(origins), lasts};
}

}  // namespace oncard::explore
