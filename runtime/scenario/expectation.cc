#include "runtime/scenario/expectation.h"

#include <utility>

namespace oncard::runtime {

Result<Expectation> ParseExpectation(std::string_view text) {
  auto timed = ParseTimedCondition(text);
  if (!timed.ok()) return timed.error();
  return Expectation{std::move(timed.value().condition), timed.value().at_us};
}

Message DescribeFailure(const CardCondition& condition, const Controller& controller) {
  if (condition.quantities().empty()) {
    return {"it names nothing that has a value", "其中没有任何有值的名称"};
  }
  return condition.DescribeValues(controller);
}

}  // namespace oncard::runtime
