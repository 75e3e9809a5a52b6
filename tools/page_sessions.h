// The sessions of a page server, by their numbers.
//
// A browser that crashes closes nothing. So where there are as many sessions as there may be, a new
// one takes the place of the one that has been unused longest, if that is long enough: its page has
// gone, or is open and forgotten.
//
// Thread-safe, but for the host of a session. Tested by tests/tools/page_sessions_test.cc.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "session/host.h"

namespace oncard::tools {

/// More sessions that are in use at a time are refused.
inline constexpr size_t kSessionsMax = 16;
/// A session without a request for so long may be ended for a new one.
inline constexpr std::chrono::minutes kUnusedTime{10};

struct PageSession {
  explicit PageSession(session::SessionHost made) : host(std::move(made)) {}

  std::atomic<int> requests = 0;  ///< that are being answered, or wait for that
  std::atomic<bool> closed = false;
  std::mutex mutex;  ///< of Handle()
  session::SessionHost host;
};

class PageSessions {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Maker = std::function<session::SessionHost()>;

  /// `make` makes the sessions; it is called by one thread at a time.
  explicit PageSessions(Maker make) : make_(std::move(make)) {}

  /// The number of a new session; nothing if there are too many.
  std::optional<uint64_t> Open(Time now);
  /// The session that a request is for; nullptr if there is none.
  std::shared_ptr<PageSession> Use(uint64_t number, Time now);
  /// Ends a session, and the run that it is at. False if there is no such session.
  bool Close(uint64_t number);

 private:
  struct Entry {
    std::shared_ptr<PageSession> session;
    Time used;  ///< when its last request came
  };
  using Entries = std::map<uint64_t, Entry>;

  void End(Entries::iterator entry);

  std::mutex mutex_;
  Maker make_;
  Entries entries_;
  uint64_t last_ = 0;
};

}  // namespace oncard::tools
