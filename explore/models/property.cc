#include "explore/models/property.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/nearest.h"
#include "base/number.h"
#include "vm/fixed_point.h"
#include "vm/symbol_names.h"

namespace oncard::explore {
namespace {

std::optional<int> ParseNumber(std::string_view text) {
  const auto value = ReadWhole<int>(text);
  return value.value_or(-1) < 0 ? std::nullopt : value;
}

}  // namespace

/// The names of a program's variables and return values.
class ModelNames {
 public:
  using Place = Property::Place;

  explicit ModelNames(const Model& model) : model_(model) {}

  Result<Place> Find(std::string_view name) const {
    const auto global = vm::FindNamed(model_.image().object.globals, name);
    if (!global.ok()) return global.error();
    if (!global.value().empty()) return Slot(name, global.value(), true, 0);
    for (const std::string_view prefix : {"ret", "thread"}) {
      if (!name.starts_with(prefix)) continue;
      std::string_view digits = name.substr(prefix.size());
      if (prefix == "thread") {
        if (!digits.ends_with(".result")) continue;
        digits.remove_suffix(std::string_view(".result").size());
      }
      if (const auto number = ParseNumber(digits)) return Returned(name, *number);
    }
    if (name.starts_with("page")) {
      const size_t dot = name.find('.');
      const auto page =
          dot == std::string_view::npos ? std::nullopt : ParseNumber(name.substr(4, dot - 4));
      if (page) return Local(*page, name.substr(dot + 1));
    }
    return Unknown(name);
  }

  Result<Place> FindInThread(std::string_view name, int thread) const {
    const ThreadSetup& setup = model_.setup(thread);
    const auto local = vm::FindNamed(LocalsOf(setup), name);
    if (!local.ok()) return local.error();
    return local.value().empty() ? Find(name) : Slot(name, local.value(), false, setup.page);
  }

 private:
  Result<Place> Returned(std::string_view name, int number) const {
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      if (model_.setup(thread).thread != number) continue;
      const auto function = static_cast<size_t>(model_.setup(thread).function);
      return Place{.returned = true,
                   .thread = thread,
                   .type = model_.image().object.functions[function].return_type};
    }
    return MakeError(1, "'{0}': there is no thread {1}", "“{0}”：没有线程 {1}", name, number);
  }

  const std::vector<vm::Symbol>& LocalsOf(const ThreadSetup& setup) const {
    return model_.image().object.functions[static_cast<size_t>(setup.function)].variables;
  }

  Result<Place> Local(int page, std::string_view name) const {
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      if (model_.setup(thread).page != page) continue;
      const auto found = vm::FindNamed(LocalsOf(model_.setup(thread)), name);
      if (!found.ok()) return found.error();
      if (found.value().empty()) break;
      return Slot(name, found.value(), false, page);
    }
    return MakeError(1, "no thread has a variable '{0}' on page {1}", "数据页 {1} 上没有变量“{0}”",
                     name, page);
  }

  static Result<Place> Slot(std::string_view name, const std::vector<vm::NamedSlots>& found,
                            bool global, int page) {
    const vm::NamedSlots& slots = found.front();
    if (!slots.is_number) {
      size_t count = 0;
      for (const vm::NamedSlots& each : found) count += each.count;
      return MakeError(1, "'{0}' has {1} elements: write one of them, such as '{2}'",
                       "“{0}”有 {1} 个元素：应写其中一个，如“{2}”", name, count,
                       vm::NameOfElement(*slots.symbol, slots.first));
    }
    vm::SlotAddress slot;
    slot.global = global;
    slot.page = static_cast<uint8_t>(page);
    slot.id = static_cast<uint16_t>(slots.symbol->id + slots.first);
    slot.type = slots.symbol->type;
    return Place{.slot = slot, .type = slot.type};
  }

  Result<Place> Unknown(std::string_view name) const {
    Nearest nearest(name);
    for (const vm::Symbol& symbol : model_.image().object.globals) {
      nearest.Add(symbol.name);
      nearest.Add(symbol.written);
    }
    if (!nearest.best().empty()) {
      return MakeError(1, "there is no variable '{0}'; did you mean '{1}'?",
                       "没有变量“{0}”；是否想写“{1}”？", name, nearest.best());
    }
    return MakeError(1, "there is no variable '{0}'", "没有变量“{0}”", name);
  }

  const Model& model_;
};

Result<Property> Property::Bind(runtime::Condition condition, const Model& model) {
  const ModelNames names(model);
  Property property;
  for (const std::string& name : condition.names()) {
    auto place = names.Find(name);
    if (!place.ok()) return place.error();
    property.places_.push_back(place.value());
  }
  property.condition_ = std::move(condition);
  return property;
}

Result<Property> Property::BindInThread(runtime::Condition condition, int thread,
                                        const Model& model) {
  const ModelNames names(model);
  Property property;
  for (const std::string& name : condition.names()) {
    auto place = names.FindInThread(name, thread);
    if (!place.ok()) return place.error();
    property.places_.push_back(place.value());
  }
  property.condition_ = std::move(condition);
  return property;
}

StatementCheck Property::AsCheck(int requirement, int thread, const Model& model) const {
  StatementCheck check = {
      .requirement = requirement,
      .holds = [property = *this](const Model& state) { return property.Holds(state); }};
  for (const Place& place : places_) {
    if (!place.returned && place.slot.global) {
      check.globals.push_back(place.slot.id);
    } else if (!place.returned && thread >= 0 && place.slot.page == model.setup(thread).page) {
      check.locals.push_back(place.slot.id);
    } else {
      check.sees_others = true;
    }
  }
  return check;
}

bool Property::SeesLocals() const {
  return std::ranges::any_of(
      places_, [](const Place& place) { return !place.returned && !place.slot.global; });
}

bool Property::SeesGlobalsAlone() const {
  return std::ranges::all_of(
      places_, [](const Place& place) { return !place.returned && place.slot.global; });
}

bool Property::Holds(const Model& model) const {
  return condition_.Holds([&](size_t name) {
    const Place& place = places_[name];
    const int64_t raw = place.returned ? model.ReturnValue(place.thread) : model.Read(place.slot);
    return place.type == vm::DataType::kDouble ? vm::DoubleFromFixed(raw)
                                               : static_cast<double>(static_cast<int32_t>(raw));
  });
}

}  // namespace oncard::explore
