#include "runtime/conditions/condition.h"

#include <algorithm>

namespace oncard::runtime {

bool Condition::HasTolerance() const {
  return std::ranges::any_of(elements_, [](const Element& element) {
    return (element.kind == Kind::kEqual || element.kind == Kind::kNotEqual) && element.number != 0;
  });
}

std::optional<Condition::Comparison> Condition::AsComparison() const {
  if (elements_.size() != 3) return std::nullopt;
  const Element& left = elements_[0];
  const Element& right = elements_[1];
  const Element& comparison = elements_[2];
  if (left.kind != Kind::kName || comparison.kind < Kind::kEqual ||
      comparison.kind > Kind::kGreaterEqual) {
    return std::nullopt;
  }
  Comparison found = {left.name, comparison.kind, right.number, comparison.number};
  if (right.kind == Kind::kName) found.right = size_t{right.name};
  return found;
}

}  // namespace oncard::runtime
