#include "explore/engines/trace_names.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace oncard::explore {
namespace {

/// Counts the traces that are equal to an earlier one; `seen` is used as a table.
int64_t CountRepeatedIn(const uint64_t* begin, const uint64_t* end, std::vector<uint64_t>* seen) {
  const auto count = static_cast<size_t>(end - begin);
  const size_t size = std::bit_ceil(2 * count + 1);
  seen->assign(size, 0);  // 0: an empty place
  bool zero = false;      // the identifier 0 was seen
  int64_t repeated = 0;
  for (const uint64_t* trace = begin; trace != end; ++trace) {
    if (*trace == 0) {
      repeated += zero ? 1 : 0;
      zero = true;
      continue;
    }
    size_t place = *trace & (size - 1);
    while ((*seen)[place] != 0 && (*seen)[place] != *trace) place = (place + 1) & (size - 1);
    repeated += (*seen)[place] == *trace ? 1 : 0;
    (*seen)[place] = *trace;
  }
  return repeated;
}

}  // namespace

int64_t TraceNames::CountRepeated() const {
  // Distributes them by their first bits to parts that fit into a cache, which is faster than one
  // table that is larger than the processor's caches.
  constexpr int kPartBits = 12;
  std::vector<size_t> ends(size_t{1} << kPartBits);
  const auto part_of = [](uint64_t trace) {
    return static_cast<size_t>(trace >> (64 - kPartBits));
  };
  for (const uint64_t trace : traces_) ++ends[part_of(trace)];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<size_t> begins = ends;
  std::vector<uint64_t> parts(traces_.size());
  for (const uint64_t trace : traces_) parts[--begins[part_of(trace)]] = trace;
  int64_t repeated = 0;
  std::vector<uint64_t> seen;
  for (size_t part = 0; part < ends.size(); ++part) {
    repeated += CountRepeatedIn(parts.data() + begins[part], parts.data() + ends[part], &seen);
  }
  return repeated;
}

}  // namespace oncard::explore
