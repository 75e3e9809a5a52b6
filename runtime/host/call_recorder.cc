#include "runtime/host/call_recorder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "runtime/host/host_clock.h"

namespace oncard::runtime {
namespace {

Error OpenError(const std::string& path) {
  if (errno == EWOULDBLOCK) {
    return MakeError(1, "cannot write the record of calls '{}': another process is writing it",
                     "无法写入调用记录“{}”：另一进程正在写入", path);
  }
  return MakeError(1, "cannot write the record of calls '{}': {}", "无法写入调用记录“{}”：{}", path,
                   std::strerror(errno));
}

}  // namespace

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
  if (!file_.is_open()) {
    if (!file_.Open(path_)) return OpenError(path_);
    WriteLine(FormatRecordHead());
  }
  WriteLine(FormatRecordedOpening(card, scenario, bare));
  return {};
}

void CallRecorder::Write(int card, const RecordedCall& call) {
  const std::lock_guard lock(mutex_);
  line_.clear();
  AppendRecordedCall(card, call, &line_);
  WriteLine(line_);
}

void CallRecorder::Close(int card, const CallRecord::End& end) {
  const std::lock_guard lock(mutex_);
  WriteLine(FormatRecordedEnd(card, end));
}

void CallRecorder::Finish() {
  const std::lock_guard lock(mutex_);
  file_.Finish();
}

void CallRecorder::LeaveToParent() {
  const std::lock_guard lock(mutex_);
  in_child_ = in_child_ || file_.is_open();
  file_.Abandon();
}

void CallRecorder::WriteLine(const std::string& line) {
  if (in_child_ || lost_) return;
  lost_ = !file_.Append(line);
}

}  // namespace oncard::runtime
