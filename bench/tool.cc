#include "bench/tool.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "bench/measure.h"

namespace oncard::bench {
namespace {

/// Starts `oncard` with its output at `out`, which may be -1 for nowhere.
pid_t Start(std::vector<std::string> arguments, int out) {
  arguments.insert(arguments.begin(), "oncard");
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  std::fflush(stdout);  // the child must not print it again
  const pid_t child = ::fork();
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    if (::dup2(out < 0 ? nowhere : out, STDOUT_FILENO) < 0 || ::dup2(nowhere, STDERR_FILENO) < 0) {
      ::_exit(127);
    }
    ::execv(ONCARD_TOOL, words.data());
    ::_exit(127);
  }
  if (child < 0) Fail("cannot start oncard");
  return child;
}

}  // namespace

std::string NewFolder() {
  char folder[] = "/tmp/oncard-bench-XXXXXX";
  if (::mkdtemp(folder) == nullptr) Fail("cannot make a folder");
  return folder;
}

void RunTool(std::vector<std::string> arguments) {
  const std::string command = arguments.front();
  const pid_t child = Start(std::move(arguments), -1);
  int status = 0;
  if (::waitpid(child, &status, 0) != child || status != 0) Fail("oncard " + command + " failed");
}

ToolRun MeasureTool(std::vector<std::string> arguments) {
  const std::string command = arguments.front();
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) Fail("cannot make a pipe");
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = Start(std::move(arguments), ends[1]);
  ::close(ends[1]);
  ToolRun run;
  std::array<char, 4096> text{};
  for (ssize_t size = 0; (size = ::read(ends[0], text.data(), text.size())) > 0;) {
    run.out.append(text.data(), static_cast<size_t>(size));
  }
  ::close(ends[0]);
  int status = 0;
  rusage usage{};
  if (::wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) ||
      WEXITSTATUS(status) == 127) {
    Fail("oncard " + command + " failed");
  }
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.peak_bytes = static_cast<double>(usage.ru_maxrss) * 1024;
  return run;
}

}  // namespace oncard::bench
