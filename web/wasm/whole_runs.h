// Requests that need no session: run a scenario from its beginning to its end, or explore it. All
// files are in the request. web/README.md describes requests and answers.
// Tested by tests/web/module_test.mjs.
#pragma once

#include <string>
#include <string_view>

namespace oncard::web {

/// Answers one request, a JSON object, with a JSON object in one line that ends in a newline.
/// Anything may be in the request: what cannot be used is an answer with `error`. Deterministic:
/// the same request gives the same bytes.
std::string HandleRequest(std::string_view request);

}  // namespace oncard::web
