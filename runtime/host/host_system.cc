#include "runtime/host/host_system.h"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "runtime/host/host_api.h"

namespace oncard::runtime {
namespace {

/// The exit code of a host that ends with 0.
std::atomic<int> success = 0;

}  // namespace

// Handles are those that the library makes: addresses of its objects.
bool CanBeHandle(const void* handle) { return IsAddress(handle); }

const char kNameSeparator = ':';

std::string FolderOfProgram() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::string() : program.parent_path().string();
}

bool AppendLine(const char* path, std::string_view line) {
  const int file = ::open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return false;
  const bool written = ::write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  ::close(file);
  return written;
}

void WriteToStandardError(std::span<const std::string_view> parts) {
  std::array<iovec, 8> pieces;
  const size_t count = parts.size() < pieces.size() ? parts.size() : pieces.size();
  for (size_t i = 0; i < count; ++i) {
    pieces[i] = {const_cast<char*>(parts[i].data()), parts[i].size()};
  }
  [[maybe_unused]] const ssize_t written =
      ::writev(STDERR_FILENO, pieces.data(), static_cast<int>(count));
}

void ExitHost(int code) { std::exit(code); }

void EndProcess(int code) {
  std::fflush(nullptr);
  ::_exit(code);
}

void ReplaceSuccess(int code) {
  success = code;
  // Only such a function is given the host's exit code. The C library calls it next.
  ::on_exit(
      [](int status, void*) {
        if (status == 0) ::_exit(success);
      },
      nullptr);
}

}  // namespace oncard::runtime
