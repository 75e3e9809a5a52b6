// Random programs in the form of motion programs: loops, arrays, shared counters, waits.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "vm/machine.h"
#include "vm/object.h"

namespace oncard::vm {

struct RandomProgram {
  struct Binding {
    int thread = 0;
    int function = 0;  ///< from 0
    int page = 0;
  };
  struct Value {
    SlotAddress slot;
    int64_t raw = 0;
  };
  Object object;
  std::vector<Binding> bindings;
  std::vector<Value> values;  ///< values of the variables before the start
};

/// Random numbers that are the same with every standard library.
class RandomNumbers {
 public:
  explicit RandomNumbers(uint64_t seed) : engine_(seed) {}
  /// Between `low` and `high`, both included.
  int64_t Between(int64_t low, int64_t high) {
    return low + static_cast<int64_t>(engine_() % static_cast<uint64_t>(high - low + 1));
  }
  bool OneIn(int64_t n) { return Between(1, n) == 1; }
  template <typename T, size_t size>
  T Pick(const T (&values)[size]) {
    return values[static_cast<size_t>(Between(0, static_cast<int64_t>(size) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

/// One to four functions on one to 32 threads; runs with ThreadCommands.
RandomProgram MakeRandomProgram(RandomNumbers& random);

/// Loads it, sets its variables and starts its threads under a policy.
void StartProgram(const RandomProgram& program, const Policy& policy, const CommandTable& commands,
                  Machine* machine);

}  // namespace oncard::vm
