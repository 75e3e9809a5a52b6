// A requirement on the states of a program without its card: a condition
// (runtime/conditions/condition.h) on the program's variables and results, as in
//
//   x == 6 && ret0 + ret1 >= 1
//
// Names: globals `v`, `a[3]`, `s.member`; locals `pageN.v`; `retN` or `threadN.result`, the return
// value of thread N. Tested by tests/explore/property_test.cc.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "explore/models/model.h"
#include "runtime/conditions/condition.h"

namespace oncard::explore {

class Property {
 public:
  /// Resolves the names of a condition. Fails if one is unknown. A global hides anything else with
  /// its name.
  static Result<Property> Bind(runtime::Condition condition, const Model& model);
  /// The same for an assert: a bare name is first a local of the thread, which is counted as in the
  /// model.
  static Result<Property> BindInThread(runtime::Condition condition, int thread,
                                       const Model& model);

  /// A condition whose names are not resolved: it has only a text.
  static Property Of(runtime::Condition condition) {
    Property property;
    property.condition_ = std::move(condition);
    return property;
  }

  const std::string& text() const { return condition_.text(); }
  /// True if it names a local variable.
  bool SeesLocals() const;
  /// True if it names globals alone.
  bool SeesGlobalsAlone() const;
  /// It as a check of statements that a thread executes; -1: of any thread.
  StatementCheck AsCheck(int requirement, int thread, const Model& model) const;
  /// Evaluates it in the current state of a model of the same program.
  bool Holds(const Model& model) const;

 private:
  friend class ModelNames;
  /// The value to which a name refers.
  struct Place {
    bool returned = false;
    int thread = 0;             ///< the thread whose result it is
    vm::SlotAddress slot = {};  ///< of a variable
    vm::DataType type = vm::DataType::kInt;
  };

  runtime::Condition condition_;
  std::vector<Place> places_;  ///< of the condition's names
};

}  // namespace oncard::explore
