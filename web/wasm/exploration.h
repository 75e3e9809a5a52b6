// The answer to a request to explore. Deterministic. Tested by tests/web/.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "session/arguments.h"

namespace oncard::web {

/// `language` becomes that of the request, `missing` the files that it needs and did not bring.
Result<session::Json> Explore(const session::Json& json, Language* language,
                              std::vector<std::string>* missing);

}  // namespace oncard::web
