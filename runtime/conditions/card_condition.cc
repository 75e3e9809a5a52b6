#include "runtime/conditions/card_condition.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/number.h"
#include "runtime/sim/controller.h"
#include "vm/image.h"

namespace oncard::runtime {
namespace {

/// The name in quantity.h: `retN` means `threadN.result` unless there is a global with that name.
std::string QuantityName(const std::string& name, const Controller& controller) {
  constexpr std::string_view kReturned = "ret";
  const vm::Image* image = controller.machine().image();
  const bool global = image != nullptr && vm::FindGlobal(*image, name) != nullptr;
  if (!global && name.starts_with(kReturned) &&
      ReadWhole<unsigned>(std::string_view(name).substr(kReturned.size()))) {
    return fmt::format("thread{}.result", name.substr(kReturned.size()));
  }
  return name;
}

}  // namespace

Result<CardCondition> CardCondition::Bind(Condition condition, const Controller& controller) {
  std::vector<std::string> names;
  for (const std::string& name : condition.names()) {
    names.push_back(QuantityName(name, controller));
  }
  return Bind(std::move(condition), names, controller);
}

Result<CardCondition> CardCondition::BindInThread(Condition condition, int thread,
                                                  const Controller& controller) {
  std::vector<std::string> names;
  for (const std::string& name : condition.names()) {
    std::string local = NameInThread(name, thread, controller);
    names.push_back(local == name ? QuantityName(name, controller) : std::move(local));
  }
  return Bind(std::move(condition), names, controller);
}

Result<CardCondition> CardCondition::Read(std::string_view text, const Controller& controller) {
  auto condition = ParseCondition(text);
  if (!condition.ok()) return condition.error();
  return Bind(std::move(condition).value(), controller);
}

Result<CardCondition> CardCondition::ReadInThread(std::string_view text, int thread,
                                                  const Controller& controller) {
  auto condition = ParseCondition(text);
  if (!condition.ok()) return condition.error();
  return BindInThread(std::move(condition).value(), thread, controller);
}

Result<CardCondition> CardCondition::Bind(Condition condition,
                                          const std::vector<std::string>& names,
                                          const Controller& controller) {
  std::vector<Quantity> quantities;
  for (const std::string& full : names) {
    auto found = ResolveQuantity(full, controller);
    if (!found.ok()) return found.error();
    if (found.value().size() != 1) {
      return MakeError(1, "'{0}' is an array of {1} elements: write one of them, such as '{2}'",
                       "“{0}”是有 {1} 个元素的数组：应写其中一个，如“{2}”", full,
                       found.value().size(), found.value().front().name);
    }
    quantities.push_back(std::move(found.value().front()));
  }
  return CardCondition(std::move(condition), std::move(quantities));
}

Message CardCondition::DescribeValues(const Controller& controller) const {
  return DescribeValues(controller, [this](size_t name) { return quantities_[name].name; });
}

Message CardCondition::DescribeValues(const Controller& controller,
                                      const std::function<std::string(size_t)>& name_of) const {
  std::vector<std::string> named;
  Message values;
  for (size_t i = 0; i < quantities_.size(); ++i) {
    std::string name = name_of(i);
    if (std::ranges::find(named, name) != named.end()) continue;
    const std::string value = DescribeQuantity(quantities_[i], controller);
    values.en += fmt::format("{}{} is {}", named.empty() ? "" : ", ", name, value);
    values.zh += fmt::format("{}{} 为 {}", named.empty() ? "" : "，", name, value);
    named.push_back(std::move(name));
  }
  return values;
}

Message DescribeFailure(const CardCondition& condition, const Controller& controller) {
  if (condition.quantities().empty()) {
    return {"it names nothing that has a value", "其中没有任何有值的名称"};
  }
  return condition.DescribeValues(controller);
}

std::string DescribeQuantity(const Quantity& quantity, const Controller& controller) {
  const std::string text = FormatQuantity(quantity, controller);
  const AxisUnit& unit = quantity.axis_unit;
  return unit.named() ? fmt::format("{} {}", text, unit.NameOf(quantity.measure())) : text;
}

std::string FormatQuantity(const Quantity& quantity, const Controller& controller) {
  return FormatNumber(ReadQuantity(quantity, controller), FormOfQuantity(quantity, controller));
}

}  // namespace oncard::runtime
