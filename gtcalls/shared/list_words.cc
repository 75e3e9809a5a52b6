#include "gtcalls/shared/list_words.h"

#include "motion/common/state_hash.h"

namespace oncard::gtcalls {

static_assert(motion::kFieldsComplete<ListWords>);

void ListWords::Free(int32_t done) {
  for (; freed < done && !segments.empty(); ++freed) {
    used -= segments.front();
    segments.Pop();
  }
}

void ListWords::AddCommand(uint32_t words) {
  used += words;
  since_segment += words;
}

void ListWords::AddSegment(uint32_t words) {
  used += words;
  segments.Push(since_segment + words);
  since_segment = 0;
}

uint32_t WordsOf(const Command& command) {
  uint32_t words = 1;
  for (const Parameter& parameter : command.parameters) {
    words += parameter.type == Scalar::kDouble || parameter.type == Scalar::kLong ? 2 : 1;
  }
  return words;
}

}  // namespace oncard::gtcalls
