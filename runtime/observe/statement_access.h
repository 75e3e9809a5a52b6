// The resources that a statement accesses, including GT commands: the variables of its operands,
// and the resources that its command reads or writes according to the catalogue, such as an axis, a
// coordinate system or an output word.
//
// Statements of different threads depend on each other if they access the same resource and one of
// them writes it. Tested by tests/explore/statement_access_test.cc; the catalogue's rows are tested
// by command_access_test.cc.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gtcalls/catalogue.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// One resource, or all resources of its kind.
struct Touched {
  static constexpr uint32_t kAll = ~uint32_t{0};

  gtcalls::Resource resource = gtcalls::Resource::kNone;
  uint32_t number = kAll;  ///< of a global: its slot; of an axis and the like: from 1
  bool write = false;
  bool operator==(const Touched&) const = default;
};

/// Resources that are private to a thread are not included.
using StatementAccess = std::vector<Touched>;

/// The accesses of the next statement of a running thread, for the current values of the variables.
StatementAccess NextAccess(const Controller& controller, int thread);

/// The first resource through which one depends on the other; empty if they are independent.
const Touched* FindDependence(const StatementAccess& one, const StatementAccess& other);

/// The name of a resource: `axis 1`, `crd 2`, a variable's name.
std::string NameOf(const Touched& touched, const vm::Object& object);

}  // namespace oncard::runtime
