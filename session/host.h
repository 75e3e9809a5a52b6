// The session protocol: one request as JSON text in, lines of JSON out. The last line is the
// response; lines before it are events that belong to the request. docs/session-protocol.md
// describes requests and answers for clients; `oncard debug`, `oncard serve` and the WebAssembly
// module speak it.
//
// The answers are a deterministic function of the requests, and of the files if there is a reader.
// Any text is safe to give. Not thread-safe.
// Tested by tests/session/host_test.cc and tests/session/protocol_page_test.cc.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "compiler/compiler.h"
#include "runtime/scenario/file/scenario.h"
#include "vm/object.h"

namespace oncard::session {

inline constexpr int kProtocolVersion = 1;

/// A request, for documentation and messages.
struct RequestText {
  std::string_view name;
  std::string_view arguments;  ///< their names, separated by blanks; optional ones in brackets
};

/// Completes the scenario of a source that runs by itself from the source's comments.
using CommentReader = std::function<Result<void>(const std::string& path, std::string_view source,
                                                 const vm::Object& object, runtime::Scenario*)>;

struct RecordedHost;

/// Reads the record of a host: its text, its path, and the card and opening that are wanted.
using CallReader = Result<RecordedHost> (*)(const std::string& text, const std::string& path,
                                            std::optional<int> card, int opening);

class SessionHost {
 public:
  /// `reader` reads files that a request names without their content; empty: there are none.
  /// `comments` reads the comments of sources (explore/source_comments.h); empty: they are only
  /// comments.
  /// `calls` reads the records of hosts (recorded_host.h); nullptr: they are refused.
  explicit SessionHost(compiler::FileReader reader = {}, CommentReader comments = {},
                       CallReader calls = nullptr);
  SessionHost(SessionHost&&) noexcept;
  SessionHost& operator=(SessionHost&&) noexcept;
  ~SessionHost();

  /// All requests, in the order of the documentation.
  static std::span<const RequestText> RequestTexts();

  /// Executes one request. Every line of the answer ends in a newline.
  std::string Handle(std::string_view request);

  /// Nobody wants answers any more: the walk or run of a Handle() in another thread ends early, and
  /// so do later ones. Thread-safe.
  void End();

 private:
  class Requests;
  std::unique_ptr<Requests> requests_;
};

}  // namespace oncard::session
