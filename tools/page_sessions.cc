#include "tools/page_sessions.h"

#include <algorithm>

namespace oncard::tools {

std::optional<uint64_t> PageSessions::Open(Time now) {
  const std::lock_guard lock(mutex_);
  if (entries_.size() == kSessionsMax) {
    const auto unused = std::min_element(
        entries_.begin(), entries_.end(),
        [](const auto& one, const auto& other) { return one.second.used < other.second.used; });
    if (now - unused->second.used < kUnusedTime) return std::nullopt;
    End(unused);
  }
  entries_.emplace(++last_, Entry{std::make_shared<PageSession>(make_()), now});
  return last_;
}

std::shared_ptr<PageSession> PageSessions::Use(uint64_t number, Time now) {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(number);
  if (found == entries_.end()) return nullptr;
  found->second.used = now;
  return found->second.session;
}

bool PageSessions::Close(uint64_t number) {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(number);
  if (found == entries_.end()) return false;
  End(found);
  return true;
}

void PageSessions::End(Entries::iterator entry) {
  PageSession& session = *entry->second.session;
  session.closed = true;
  session.host.End();
  entries_.erase(entry);
}

}  // namespace oncard::tools
