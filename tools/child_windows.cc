#include "tools/child_windows.h"

#include <array>

namespace oncard::tools {
namespace {

/// The job of all programs that are started: the system ends them with its last handle, which this
/// process holds.
HANDLE Job() {
  static const HANDLE job = [] {
    const HANDLE made = ::CreateJobObjectA(nullptr, nullptr);
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits = {};
    limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
    ::SetInformationJobObject(made, JobObjectExtendedLimitInformation, &limits, sizeof limits);
    return made;
  }();
  return job;
}

SECURITY_ATTRIBUTES Inherited() {
  SECURITY_ATTRIBUTES attributes = {};
  attributes.nLength = sizeof attributes;
  attributes.bInheritHandle = TRUE;
  return attributes;
}

std::string SystemText(DWORD error) {
  std::array<char, 512> text;
  DWORD size = ::FormatMessageA(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr,
                                error, 0, text.data(), text.size(), nullptr);
  while (size > 0 && (text[size - 1] == '\n' || text[size - 1] == '\r')) --size;
  return size > 0 ? std::string(text.data(), size) : std::to_string(error);
}

}  // namespace

SystemHandle ScratchFile() {
  std::array<char, MAX_PATH + 1> folder;
  std::array<char, MAX_PATH + 1> name;
  const DWORD size = ::GetTempPathA(static_cast<DWORD>(folder.size()), folder.data());
  if (size == 0 || ::GetTempFileNameA(folder.data(), "onc", 0, name.data()) == 0)
    return SystemHandle();
  SECURITY_ATTRIBUTES inherited = Inherited();
  return SystemHandle(::CreateFileA(name.data(), GENERIC_READ | GENERIC_WRITE,
                                    FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                    &inherited, CREATE_ALWAYS,
                                    FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr));
}

std::string ContentOf(const SystemHandle& file) {
  std::string content;
  ::SetFilePointer(file.get(), 0, nullptr, FILE_BEGIN);
  std::array<char, 65536> buffer;
  DWORD count = 0;
  while (::ReadFile(file.get(), buffer.data(), static_cast<DWORD>(buffer.size()), &count,
                    nullptr) != 0 &&
         count > 0) {
    content.append(buffer.data(), count);
  }
  return content;
}

Result<SystemHandle> StartChild(const std::string& program, const std::string& command_line,
                                const ChildStreams& streams) {
  STARTUPINFOA info = {};
  info.cb = sizeof info;
  info.dwFlags = STARTF_USESTDHANDLES;
  info.hStdInput = streams.in;
  info.hStdOutput = streams.out;
  info.hStdError = streams.err;
  PROCESS_INFORMATION process = {};
  std::string line = command_line;  // the system writes into it
  // It runs when it belongs to the job, so that it cannot outlive this process.
  if (::CreateProcessA(program.empty() ? nullptr : program.c_str(), line.data(), nullptr, nullptr,
                       TRUE, CREATE_SUSPENDED, nullptr, nullptr, &info, &process) == 0) {
    return MakeError(1, "{0}", "{0}", SystemText(::GetLastError()));
  }
  ::AssignProcessToJobObject(Job(), process.hProcess);
  ::ResumeThread(process.hThread);
  ::CloseHandle(process.hThread);
  return SystemHandle(process.hProcess);
}

// Words are quoted. A backslash before a quote, or before the quote at the end, is doubled.
std::string CommandLineOf(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    line += line.empty() ? "\"" : " \"";
    size_t backslashes = 0;
    for (const char c : word) {
      if (c == '"') line.append(backslashes + 1, '\\');
      backslashes = c == '\\' ? backslashes + 1 : 0;
      line += c;
    }
    line.append(backslashes, '\\');
    line += '"';
  }
  return line;
}

}  // namespace oncard::tools
