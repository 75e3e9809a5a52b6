// What can still matter to a thread from a statement on, wherever its jumps lead: the globals that
// it can access, and the locals whose values it can read before it writes them.
//
// Both are found from the code alone. They can be too many, never too few. Deterministic; can be
// read by several threads. Tested by tests/explore/thread_future_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "explore/models/model.h"

namespace oncard::explore {

/// Sets of globals: bit n stands for those whose number is n modulo 64.
struct AccessBits {
  uint64_t reads = 0;
  uint64_t writes = 0;
  bool operator==(const AccessBits&) const = default;

  void Add(const AccessBits& other) {
    reads |= other.reads;
    writes |= other.writes;
  }
  /// False only if no access of one can depend on one of the other.
  bool MayDependOn(const AccessBits& other) const {
    return (writes & (other.reads | other.writes)) != 0 || (reads & other.writes) != 0;
  }
};
AccessBits BitsOf(const AccessSet& access);

class ThreadFuture {
 public:
  ThreadFuture(const Model& model, int thread);

  /// What a thread that runs accesses from the statement at this position on, with that one.
  const AccessBits& Accesses(int position) const { return at_[Index(position)].accesses; }
  /// The slots of locals whose values can matter to it, in order; all of them in a thread that is
  /// too large to look at each.
  const std::vector<uint32_t>& Locals(int position) const {
    return all_.empty() ? at_[Index(position)].locals : all_;
  }

 private:
  struct Place {
    AccessBits accesses;
    std::vector<uint32_t> locals;
  };

  static size_t Index(int position) { return static_cast<size_t>(position); }

  std::vector<Place> at_;
  std::vector<uint32_t> all_;  ///< the locals, if they are not looked at
};

/// Lets a model forget the locals of its threads that cannot matter any more
/// (Model::ForgetDeadLocals()).
void FindDeadLocals(Model* model);

}  // namespace oncard::explore
