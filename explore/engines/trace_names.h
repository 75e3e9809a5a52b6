// Identifiers of traces (dpor.h), and how often one was executed again. Tested by
// tests/explore/dpor_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace oncard::explore {

/// The identifier of an event: its thread, and the identifiers of the events that immediately
/// happen before it, among them the one before it in its thread. `before` is the sum of those. The
/// sum of the identifiers of its events identifies a trace: it does not depend on the order of
/// independent events.
constexpr uint64_t NameEvent(int thread, uint64_t before) {
  const uint64_t name = (before + static_cast<uint64_t>(thread) + 1) * 0x9e3779b97f4a7c15ULL;
  return (name ^ name >> 32) * 0xff51afd7ed558ccdULL;
}

/// The identifiers of the executions of a search.
class TraceNames {
 public:
  /// Adds one; those after the first 67 million are ignored.
  void Add(uint64_t trace) {
    if (traces_.size() < kMost) traces_.push_back(trace);
  }
  /// How many of them had been added before.
  int64_t CountRepeated() const;

 private:
  /// Half a gigabyte.
  static constexpr size_t kMost = size_t{1} << 26;

  std::vector<uint64_t> traces_;
};

}  // namespace oncard::explore
