#include "explore/models/property.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/nearest.h"
#include "base/number.h"
#include "vm/fixed_point.h"

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

  Result<Place> Find(std::string_view name, std::optional<int> index) const {
    const vm::Symbol* global = vm::FindGlobal(model_.image(), name);
    if (global != nullptr) return Slot(*global, index, true, 0);
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
      if (page) return Local(*page, name.substr(dot + 1), index);
    }
    return Unknown(name);
  }

  Result<Place> FindInThread(std::string_view name, std::optional<int> index, int thread) const {
    const ThreadSetup& setup = model_.setup(thread);
    const vm::Symbol* local = vm::FindLocal(model_.image(), setup.function, name);
    return local != nullptr ? Slot(*local, index, false, setup.page) : Find(name, index);
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

  Result<Place> Local(int page, std::string_view name, std::optional<int> index) const {
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      if (model_.setup(thread).page != page) continue;
      const vm::Symbol* symbol = vm::FindLocal(model_.image(), model_.setup(thread).function, name);
      if (symbol == nullptr) break;
      return Slot(*symbol, index, false, page);
    }
    return MakeError(1, "no thread has a variable '{0}' on page {1}", "数据页 {1} 上没有变量“{0}”",
                     name, page);
  }

  Result<Place> Slot(const vm::Symbol& symbol, std::optional<int> index, bool global,
                     int page) const {
    if (index.has_value() != (symbol.array_size != 0) || index.value_or(0) >= symbol.slots()) {
      return MakeError(1, "'{0}' has {1} elements: write an index below that in brackets",
                       "“{0}”有 {1} 个元素：请在方括号中写出下标", symbol.name, symbol.array_size);
    }
    vm::SlotAddress slot;
    slot.global = global;
    slot.page = static_cast<uint8_t>(page);
    slot.id = static_cast<uint16_t>(symbol.id + index.value_or(0));
    slot.type = symbol.type;
    return Place{.slot = slot, .type = symbol.type};
  }

  Result<Place> Unknown(std::string_view name) const {
    Nearest nearest(name);
    for (const vm::Symbol& symbol : model_.image().object.globals) nearest.Add(symbol.name);
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
  for (const runtime::Condition::Name& name : condition.names()) {
    auto place = names.Find(name.base, name.index);
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
  for (const runtime::Condition::Name& name : condition.names()) {
    auto place = names.FindInThread(name.base, name.index, thread);
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
