// The requests of the session protocol that are about a source: what an editor asks while it is
// being written (editor/). They need no session and do not touch it.
// Tested by tests/session/editor_requests_test.cc.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "session/arguments.h"
#include "session/host.h"

namespace oncard::session {

struct EditorContext {
  const compiler::FileReader& reader;  ///< of files that the request does not bring
  Language language;
  std::vector<std::string>* missing;  ///< receives the files that are needed and do not exist
};

struct EditorRequest {
  RequestText text;
  Result<Json> (*answer)(Arguments& arguments, const EditorContext& context);
};

/// In the order of the documentation.
std::span<const EditorRequest> EditorRequests();

}  // namespace oncard::session
