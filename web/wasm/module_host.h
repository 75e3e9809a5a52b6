// What the module answers: the session protocol (docs/session-protocol.md), and explorations, which
// a session does not know. All files are in the requests. Tested by tests/web/.
#pragma once

#include <string>
#include <string_view>

#include "explore/source_comments.h"
#include "session/host.h"
#include "web/wasm/module_parts.h"

namespace oncard::web {

class ModuleHost {
 public:
  /// `calls` reads the records of hosts, `explorer` answers requests to explore; nullptr: they are
  /// refused.
  ModuleHost(session::CallReader calls, Explorer explorer)
      : session_({}, explore::AddComments, calls), explorer_(explorer) {}

  /// Executes one request: `explore`, as web/README.md describes it, or one of the session's. Every
  /// line of the answer ends in a newline. Any text is safe to give. Deterministic.
  std::string Handle(std::string_view request);

 private:
  session::SessionHost session_;
  Explorer explorer_;
};

}  // namespace oncard::web
