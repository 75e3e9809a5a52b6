// Ends of runs: the final values of a program's globals and the return values of its threads.
//
// If there are no requirements on a program's results, the report shows the different ones. Tested
// by tests/explore/claim_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "explore/models/card_model.h"
#include "explore/models/model.h"

namespace oncard::explore {

/// Raw values: the slots of the globals in the order of their symbols, then the return value of
/// each thread.
using End = std::vector<int64_t>;

/// The end of a run that has ended.
End EndOf(const Model& model);
End EndOf(const CardModel& model, const CardModel::State& state);

/// Keeps the smallest few of many ends: the result does not depend on the order in which they are
/// added.
class EndSet {
 public:
  static constexpr size_t kKept = 12;

  /// Each different end once.
  void Add(End end);
  /// In order.
  const std::vector<End>& ends() const { return ends_; }

 private:
  std::vector<End> ends_;
};

/// One value of an end.
struct NamedValue {
  std::string name;  ///< as requirements name it: `sum`, `a[3]`, `ret0`
  std::string value;
  bool operator==(const NamedValue&) const = default;
};

/// The ends with names of their values.
std::vector<std::vector<NamedValue>> NameEnds(const std::vector<End>& ends,
                                              const vm::Object& object,
                                              const std::vector<ThreadSetup>& threads);

}  // namespace oncard::explore
