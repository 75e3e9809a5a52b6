// What runs end with: the values of a program's globals and what its threads returned.
//
// Where nothing is asked of a program's results, the different ones are what there is to show.
// Tested by tests/explore/claim_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "explore/models/card_model.h"
#include "explore/models/model.h"

namespace oncard::explore {

/// Raw values: the slots of the globals in the order of their symbols, then what each thread
/// returned.
using End = std::vector<int64_t>;

/// Of an ended run.
End EndOf(const Model& model);
End EndOf(const CardModel& model, const CardModel::State& state);

/// Keeps the smallest few of many ends: the same ones whoever finds them, in whatever order.
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

/// The ends with names for their values.
std::vector<std::vector<NamedValue>> NameEnds(const std::vector<End>& ends,
                                              const vm::Object& object,
                                              const std::vector<ThreadSetup>& threads);

}  // namespace oncard::explore
