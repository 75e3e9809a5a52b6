#include "runtime/scenario/file/expectation.h"

#include <utility>

namespace oncard::runtime {

Result<Expectation> ParseExpectation(std::string_view text) {
  auto timed = ParseTimedCondition(text);
  if (!timed.ok()) return timed.error();
  return Expectation{std::move(timed.value().condition), timed.value().at_us};
}

}  // namespace oncard::runtime
