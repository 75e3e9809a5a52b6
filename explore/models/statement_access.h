// What a statement touches, GT commands included: the variables of its operands, and the resources
// that the catalogue says its command reads or writes, an axis, a coordinate system, an output
// word.
//
// Statements of different threads depend on each other when they touch the same and one of them
// writes it. Tested by tests/explore/statement_access_test.cc; the catalogue's rows are tested by
// command_access_test.cc.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gtcalls/catalogue.h"
#include "runtime/sim/controller.h"

namespace oncard::explore {

/// One resource, or all of its kind.
struct Touched {
  static constexpr uint32_t kAll = ~uint32_t{0};

  gtcalls::Resource resource = gtcalls::Resource::kNone;
  uint32_t number = kAll;  ///< of a global: its slot; of an axis and the like: from 1
  bool write = false;
  bool operator==(const Touched&) const = default;
};

/// Nothing that only the thread itself can see.
using StatementAccess = std::vector<Touched>;

/// Of the next statement of a running thread, as the variables are now.
StatementAccess NextAccess(const runtime::Controller& controller, int thread);

/// The first resource with which one depends on the other; nothing when they do not.
const Touched* FindDependence(const StatementAccess& one, const StatementAccess& other);

/// `axis 1`, `crd 2`, a variable's name.
std::string NameOf(const Touched& touched, const vm::Object& object);

}  // namespace oncard::explore
