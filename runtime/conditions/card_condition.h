// Conditions on what can be observed of a card with its program: their names are those of
// runtime/observe/quantity.h, and `retN` for `threadN.result`. Tested by
// tests/runtime/card_condition_test.cc.
#pragma once

#include <utility>
#include <vector>

#include "base/result.h"
#include "runtime/conditions/condition.h"
#include "runtime/observe/quantity.h"

namespace oncard::runtime {

class CardCondition {
 public:
  /// Finds the names. Fails when one is unknown or an array's. A global hides whatever else has its
  /// name. The result is meaningful for controllers with the same program.
  static Result<CardCondition> Bind(Condition condition, const Controller& controller);

  const Condition& condition() const { return condition_; }
  /// What the condition's names() stand for, in their order.
  const std::vector<Quantity>& quantities() const { return quantities_; }

  /// Evaluates it in the present state of the card.
  bool Holds(const Controller& controller) const {
    return condition_.Holds(
        [&](size_t name) { return ReadQuantity(quantities_[name], controller); });
  }
  /// What it names and the values of that, as in `x is 3, a[1] is 0`, each once; empty for a
  /// condition of numbers.
  Message DescribeValues(const Controller& controller) const;

 private:
  CardCondition(Condition condition, std::vector<Quantity> quantities)
      : condition_(std::move(condition)), quantities_(std::move(quantities)) {}

  Condition condition_;
  std::vector<Quantity> quantities_;
};

/// A quantity's value as messages show it.
std::string FormatQuantity(const Quantity& quantity, const Controller& controller);

}  // namespace oncard::runtime
