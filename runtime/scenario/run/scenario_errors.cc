#include "runtime/scenario/run/scenario_errors.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "runtime/observe/statement_access.h"
#include "vm/symbol_names.h"

namespace oncard::runtime {
namespace {

constexpr std::string_view kNameCharacters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789";

/// True for names such as `thread12`, `page3` and `ret0`.
bool NamesThread(std::string_view word) {
  for (const std::string_view prefix : {"thread", "page", "ret"}) {
    if (!word.starts_with(prefix) || word.size() == prefix.size()) continue;
    const std::string_view number = word.substr(prefix.size());
    if (number.find_first_not_of("0123456789") == std::string_view::npos) return true;
  }
  return false;
}

}  // namespace

void ScenarioErrors::AddText(const TextPlace& place, std::string_view text, const Message& why) {
  if (place.file != nullptr) return Add(place, why);
  Add(place, {fmt::format("'{}': {}", text, why.en), fmt::format("“{}”：{}", text, why.zh)});
}

bool ScenarioErrors::CanJudge(std::string_view text) const {
  if (all_bound_) return true;
  for (size_t begin = text.find_first_of(kNameCharacters); begin != std::string_view::npos;) {
    const size_t end = std::min(text.find_first_not_of(kNameCharacters, begin), text.size());
    if (NamesThread(text.substr(begin, end - begin))) return false;
    begin = text.find_first_of(kNameCharacters, end);
  }
  return true;
}

std::vector<Quantity> TraceQuantities(const Scenario& scenario, const Controller& controller,
                                      ScenarioErrors* errors) {
  std::vector<Quantity> all;
  for (size_t i = 0; i < scenario.trace.size(); ++i) {
    const std::string& name = scenario.trace[i];
    if (!errors->CanJudge(name)) continue;
    auto found = ResolveQuantity(name, controller);
    if (found.ok()) {
      std::ranges::move(found.value(), std::back_inserter(all));
    } else {
      errors->Add(PlaceOfText(scenario, "trace", i), found.error().message);
    }
  }
  return all;
}

std::vector<bool> SyncGlobals(const Scenario& scenario, const vm::Object& object,
                              ScenarioErrors* errors) {
  std::vector<bool> slots;
  for (size_t i = 0; i < scenario.sync.size(); ++i) {
    const std::string& name = scenario.sync[i];
    const auto found = vm::FindNamed(object.globals, name);
    if (!found.ok() || found.value().empty()) {
      errors->Add(PlaceOfText(scenario, "sync", i),
                  found.ok() ? MakeMessage("no global variable is named '{0}'",
                                           "没有名为“{0}”的全局变量", name)
                             : found.error().message);
      continue;
    }
    for (const vm::NamedSlots& each : found.value()) {
      const size_t begin = size_t{each.symbol->id} + each.first;
      const size_t end = begin + each.count;
      if (slots.size() < end) slots.resize(end);
      std::fill(slots.begin() + static_cast<std::ptrdiff_t>(begin),
                slots.begin() + static_cast<std::ptrdiff_t>(end), true);
    }
  }
  return slots;
}

std::vector<bool> OrderingGlobals(const Scenario& scenario, const Controller& controller,
                                  ScenarioErrors* errors) {
  const vm::Object& object = controller.machine().image()->object;
  std::vector<bool> slots = SyncGlobals(scenario, object, errors);
  const std::vector<bool> awaited = AwaitedGlobals(object, controller.family().catalogue);
  slots.resize(std::max(slots.size(), awaited.size()));
  for (size_t slot = 0; slot < awaited.size(); ++slot) {
    if (awaited[slot]) slots[slot] = true;
  }
  return slots;
}

}  // namespace oncard::runtime
