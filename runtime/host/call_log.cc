#include "runtime/host/call_log.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace oncard::runtime {

CallLog::CallLog(std::string_view setting, Language language) : language_(language) {
  constexpr std::string_view kFilePrefix = "calls:";
  if (setting.empty()) return;
  stream_ = stderr;
  if (setting == "calls") return;
  if (!setting.starts_with(kFilePrefix) || setting.size() == kFilePrefix.size()) {
    WriteLine(MakeMessage("ONCARD_LOG is '{}', expected calls or calls:FILE",
                          "ONCARD_LOG 的值为 '{}'，应为 calls 或 calls:文件名", setting)
                  .In(language));
    return;
  }
  const std::string path(setting.substr(kFilePrefix.size()));
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) {
    WriteLine(MakeMessage("cannot write the call log '{}': {}", "无法写入调用日志 '{}'：{}", path,
                          std::strerror(errno))
                  .In(language));
    return;
  }
  stream_ = file;
}

CallLog::~CallLog() {
  if (stream_ != nullptr && stream_ != stderr) std::fclose(stream_);
}

CallLog& CallLog::OfProcess() {
  // Never destroyed: other threads of the host may still make calls while the process exits. Every
  // line is flushed, so nothing is lost.
  static CallLog& log = *[] {
    const char* setting = std::getenv("ONCARD_LOG");
    return new CallLog(setting == nullptr ? "" : setting, LanguageFromEnvironment());
  }();
  return log;
}

CallLog* CallLog::Wanted() {
  CallLog& log = OfProcess();
  return log.enabled() ? &log : nullptr;
}

void CallLog::Write(const LoggedCall& call) {
  const std::lock_guard lock(mutex_);
  AppendCall(call, language_, &line_);
  EndLine();
}

void CallLog::Write(int64_t time_us, int card, const Message& what) {
  const std::lock_guard lock(mutex_);
  AppendEvent(time_us, card, what, language_, &line_);
  EndLine();
}

void CallLog::WriteLine(const std::string& line) {
  const std::lock_guard lock(mutex_);
  line_ = line;
  EndLine();
}

void CallLog::EndLine() {
  line_ += '\n';
  const bool written = std::fwrite(line_.data(), 1, line_.size(), stream_) == line_.size();
  if (std::fflush(stream_) != 0 || !written) lost_ = true;
  line_.clear();
}

}  // namespace oncard::runtime
