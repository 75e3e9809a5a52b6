#include "explore/search/search_pair.h"

namespace oncard::explore {

PairResult RunInTurn(const SearchPair& pair) {
  using First = PairResult::First;
  const std::atomic<bool> never{false};
  const std::atomic<bool>* stop = pair.progress == nullptr ? &never : &pair.progress->stop;
  const auto take_pause = [&] { return pair.progress != nullptr && pair.progress->TakePause(); };
  PairResult result;
  result.states = pair.states(stop, nullptr);
  const StateCounts& counts = result.states.counts;
  if (counts.complete || counts.bad_states > 0) {
    result.first = First::kStates;
    return result;
  }
  // A request to save the search of traces has ended that of states; there is nothing to save yet.
  take_pause();
  if (*stop) return result;
  result.traces = pair.traces(stop, take_pause);
  if (result.traces->complete() || result.traces->bad > 0) result.first = First::kTraces;
  return result;
}

}  // namespace oncard::explore
