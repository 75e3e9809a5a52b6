// What requirements ask, in words for those who do not read conditions. Depends only on its
// argument. Tested by tests/explore/requirement_words_test.cc.
#pragma once

#include "base/message.h"
#include "runtime/scenario/file/requirement.h"

namespace oncard::explore {

/// `whenever gpi[1] == 1 holds, axis1.moving == 0 holds then or at most 5 ms later`.
Message InWords(const runtime::Requirement& requirement);

}  // namespace oncard::explore
