// The resources that a statement accesses, including GT commands: the variables of its operands,
// and the resources that its command reads or writes according to the catalogue, such as an axis, a
// coordinate system or an output word.
//
// Statements of different threads depend on each other if they access the same resource and one of
// them writes it. NextPreciseAccess() also knows which outputs of a word a command sets, and which
// coordinate systems and axes a stop reaches in the present state; the schedules of the engine
// `pos` and the pairs of reports follow NextAccess().
// Tested by tests/explore/statement_access_test.cc; the catalogue's rows are tested by
// command_access_test.cc.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "gtcalls/catalogue.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// One resource, or all resources of its kind.
struct Touched {
  static constexpr uint32_t kAll = ~uint32_t{0};

  gtcalls::Resource resource = gtcalls::Resource::kNone;
  uint32_t number = kAll;  ///< of a global: its slot; of an axis and the like: from 1
  bool write = false;
  /// Of a word or module of outputs: bit n for output n, bit kFirstChannel + n for the analogue
  /// output n of a module.
  uint32_t bits = ~uint32_t{0};
  bool operator==(const Touched&) const = default;

  static constexpr uint32_t kFirstChannel = 16;
};

/// True for what belongs to the axis with its number: profile, encoder and servo controller.
bool IsOfAxis(gtcalls::Resource resource);

/// Resources that are private to a thread are not included.
using StatementAccess = std::vector<Touched>;

/// Adds the accesses that are not there.
void AddAccesses(const StatementAccess& from, StatementAccess* to);

/// The accesses of the next statement of a running thread, for the current values of the variables.
StatementAccess NextAccess(const Controller& controller, int thread);

/// The same with the parts of resources that the catalogue names (gtcalls::Part).
StatementAccess NextPreciseAccess(const Controller& controller, int thread);

/// The first resource through which one depends on the other; empty if they are independent.
const Touched* FindDependence(const StatementAccess& one, const StatementAccess& other);

/// The globals whose values statements wait for: element n is true for slot n, missing ones are
/// false.
std::vector<bool> AwaitedGlobals(const vm::Object& object, const gtcalls::Catalogue& catalogue);

/// One of two accesses to the same data, as it is named in sentences.
struct PlacedAccess {
  int thread = 0;
  int line = 0;
  bool writes = false;
};

/// `thread 0 writes x in line 3, thread 1 reads it in line 9`.
Message DescribeRacingPair(const std::string& what, const PlacedAccess& first,
                           const PlacedAccess& second);
/// The same as a data race: nothing orders the two.
Message DescribeDataRace(const std::string& what, const PlacedAccess& first,
                         const PlacedAccess& second);

/// The name of a resource: `axis 1`, `crd 2`, a variable's name.
std::string NameOf(const Touched& touched, const vm::Object& object);

}  // namespace oncard::runtime
