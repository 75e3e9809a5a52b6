// Programs that a command starts on Windows, for the other sources whose names end so.
#pragma once

#include <windows.h>

#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace oncard::tools {

/// A handle that is closed with its scope.
class SystemHandle {
 public:
  explicit SystemHandle(HANDLE handle = nullptr) : handle_(handle) {}
  SystemHandle(SystemHandle&& other) noexcept : handle_(other.handle_) { other.handle_ = nullptr; }
  SystemHandle& operator=(SystemHandle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~SystemHandle() {
    if (valid()) ::CloseHandle(handle_);
  }
  HANDLE get() const { return handle_; }
  bool valid() const { return handle_ != nullptr && handle_ != INVALID_HANDLE_VALUE; }

 private:
  HANDLE handle_;
};

/// A file without a name that a program which is started may use, empty; not valid on failure.
SystemHandle ScratchFile();
/// All that is in such a file.
std::string ContentOf(const SystemHandle& file);

struct ChildStreams {
  HANDLE in = nullptr;  ///< null: it reads nothing
  HANDLE out = nullptr;
  HANDLE err = nullptr;
};

/// Starts a program and returns its process, which ends with this one at the latest. An empty
/// `program` is the first word of the command line, searched for as in a shell.
Result<SystemHandle> StartChild(const std::string& program, const std::string& command_line,
                                const ChildStreams& streams);

/// A command line from which a program gets these words.
std::string CommandLineOf(const std::vector<std::string>& words);

}  // namespace oncard::tools
