#include "tools/project_session.h"

#include "base/files.h"
#include "base/limits.h"
#include "explore/source_comments.h"
#include "runtime/scenario/record/call_record.h"
#include "session/recorded_host.h"

namespace oncard::tools {

Result<std::string> ReadProjectFile(const std::string& path) {
  if (path.ends_with(runtime::kCallRecordEnding)) return ReadFile(path);
  const bool large = path.ends_with(".schedule") || path.ends_with(".bin");
  return ReadFile(path, large ? kScheduleKind : kSourceKind);
}

session::SessionHost NewProjectSession() {
  return session::SessionHost(ReadProjectFile, explore::AddComments, session::OpenRecordedHost);
}

}  // namespace oncard::tools
