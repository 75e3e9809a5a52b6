// A web server for one user of this computer: the files of a page, and sessions behind it.
//
// It listens on 127.0.0.1 only. All of its addresses begin with a secret, `/TOKEN/`; any other
// address does not exist. A request that was addressed to another name (DNS rebinding), or that
// another site's page has made, is refused, too.
//
//   GET    /TOKEN/...          a file of the page
//   POST   /TOKEN/sessions     a new session: {"ok":true,"session":ID}
//   POST   /TOKEN/sessions/ID  one request of the session protocol; the lines of its answer
//   DELETE /TOKEN/sessions/ID  ends the session; so does POST /TOKEN/sessions/ID/close
//
// docs/session-protocol.md describes it for clients. Tested by tests/tools/serve_command_test.cc.
#pragma once

#include <memory>
#include <string>

#include "base/message.h"
#include "base/result.h"
#include "tools/page_sessions.h"

namespace oncard::tools {

/// 128 random bits in hexadecimal.
std::string RandomToken();

class PageServer {
 public:
  /// Hands out the files of `folder`. `make` makes the sessions; it is called by one thread at a
  /// time. `language` is that of error messages.
  PageServer(const std::string& folder, std::string token, PageSessions::Maker make,
             Language language);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// Takes a port, 0: any that is free. Returns its number; fails if another program has it.
  Result<int> Bind(int port);
  /// Answers requests, in several threads, as long as the process lives; to be called once, after
  /// Bind(). Requests of one session wait for each other, six at most. Returns only on a failure.
  void Serve();

 private:
  class Routes;
  std::unique_ptr<Routes> routes_;
};

}  // namespace oncard::tools
