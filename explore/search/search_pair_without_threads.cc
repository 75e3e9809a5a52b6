// In place of search_pair.cc where there are no threads, as in WebAssembly.
#include "explore/search/search_pair.h"

namespace oncard::explore {

PairResult RunPair(const SearchPair& pair) { return RunInTurn(pair); }

}  // namespace oncard::explore
