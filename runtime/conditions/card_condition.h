// Conditions on the observable values of a card with its program. Their names are those of
// runtime/observe/quantity.h, and `retN` for `threadN.result`. Tested by
// tests/runtime/card_condition_test.cc.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "runtime/conditions/condition.h"
#include "runtime/observe/quantity.h"

namespace oncard::runtime {

class CardCondition {
 public:
  /// Resolves the names. Fails if one is unknown or the name of an array. A global hides anything
  /// else with its name. The result can be used with all controllers with the same program.
  static Result<CardCondition> Bind(Condition condition, const Controller& controller);
  /// The same with the names as the function of a thread means them (NameInThread()).
  static Result<CardCondition> BindInThread(Condition condition, int thread,
                                            const Controller& controller);
  /// ParseCondition(), then Bind() or BindInThread().
  static Result<CardCondition> Read(std::string_view text, const Controller& controller);
  static Result<CardCondition> ReadInThread(std::string_view text, int thread,
                                            const Controller& controller);

  const Condition& condition() const { return condition_; }
  /// The quantities of the condition's names(), in their order.
  const std::vector<Quantity>& quantities() const { return quantities_; }

  /// Evaluates it in the current state of the card.
  bool Holds(const Controller& controller) const {
    return condition_.Holds(
        [&](size_t name) { return ReadQuantity(quantities_[name], controller); });
  }
  /// The names in it with their values, as in `x is 3, a[1] is 0`, each once; empty for a condition
  /// without names.
  Message DescribeValues(const Controller& controller) const;
  /// The same, where `name_of` says how the condition's names() are called, by their index.
  Message DescribeValues(const Controller& controller,
                         const std::function<std::string(size_t)>& name_of) const;

 private:
  static Result<CardCondition> Bind(Condition condition, const std::vector<std::string>& names,
                                    const Controller& controller);
  CardCondition(Condition condition, std::vector<Quantity> quantities)
      : condition_(std::move(condition)), quantities_(std::move(quantities)) {}

  Condition condition_;
  std::vector<Quantity> quantities_;
};

/// Why a condition does not hold: the values of what it names.
Message DescribeFailure(const CardCondition& condition, const Controller& controller);

/// A quantity's value in the form used in messages.
std::string FormatQuantity(const Quantity& quantity, const Controller& controller);
/// The same with the unit of an axis that has one: "12.5 mm".
std::string DescribeQuantity(const Quantity& quantity, const Controller& controller);

}  // namespace oncard::runtime
