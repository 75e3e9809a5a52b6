#include "runtime/host/call_recorder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "runtime/host/clock.h"

namespace oncard::runtime {

CallRecorder* CallRecorder::Wanted() {
  // Never destroyed: other threads of the host may still make calls while the process exits.
  static CallRecorder* const recorder = []() -> CallRecorder* {
    const char* path = std::getenv("ONCARD_RECORD");
    if (path == nullptr || *path == '\0') return nullptr;
    auto* wanted = new CallRecorder;
    wanted->path_ = path;
    return wanted;
  }();
  return recorder;
}

Result<void> CallRecorder::Open(int card, const Scenario& scenario, bool bare) {
  const std::lock_guard lock(mutex_);
  if (in_child_) return {};
  if (file_ == nullptr) {
    file_ = std::fopen(path_.c_str(), "we");
    if (file_ == nullptr) {
      return MakeError(kOpenFailed, "cannot write the record of calls '{}': {}",
                       "无法写入调用记录“{}”：{}", path_, std::strerror(errno));
    }
    WriteLine(FormatRecordHead());
  }
  WriteLine(FormatRecordedOpening(card, scenario, bare));
  return {};
}

void CallRecorder::Write(int card, const RecordedCall& call) {
  const std::string line = FormatRecordedCall(card, call);
  const std::lock_guard lock(mutex_);
  WriteLine(line);
}

void CallRecorder::Close(int card, const CallRecord::End& end) {
  const std::lock_guard lock(mutex_);
  WriteLine(FormatRecordedEnd(card, end));
}

void CallRecorder::LeaveToParent() {
  const std::lock_guard lock(mutex_);
  in_child_ = file_ != nullptr;
}

void CallRecorder::WriteLine(const std::string& line) {
  if (file_ == nullptr || lost_ || in_child_) return;
  // A host that is killed leaves all of its calls.
  const bool written = std::fwrite(line.data(), 1, line.size(), file_) == line.size();
  if (std::fflush(file_) != 0 || !written) lost_ = true;
}

}  // namespace oncard::runtime
