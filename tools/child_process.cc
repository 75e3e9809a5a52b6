#include "tools/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace oncard::tools {
namespace {

using ChildClock = std::chrono::steady_clock;

/// How often it is checked whether a program that prints nothing must end.
constexpr int kOutputWaitMs = 100;

/// In the new process. `failure` receives the number of the error if the program does not start.
[[noreturn]] void Become(const ChildProgram& program, int parent, int output, int failure) {
  DieWithParent(parent);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  // main() ignores it, and a started program would inherit that.
  static_cast<void>(std::signal(SIGXFSZ, SIG_DFL));
  std::vector<char*> words;
  words.reserve(program.words.size() + 1);
  for (const std::string& word : program.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  for (const std::string& variable : program.environment) {
    ::putenv(const_cast<char*>(variable.c_str()));
  }
  if (program.folder.empty() || ::chdir(program.folder.c_str()) == 0) {
    ::execvp(words[0], words.data());
  }
  const int error = errno;
  static_cast<void>(!::write(failure, &error, sizeof error));
  ::_exit(127);
}

void Keep(std::string_view more, std::string* output) {
  output->append(more);
  if (output->size() > kOutputKept) output->erase(0, output->size() - kOutputKept);
}

/// Reads the output until the program has ended; kills it at its limit. What it has left in the
/// background may print up to the limit, too.
ChildEnd ReadToEnd(const ChildProgram& program, pid_t process, int output) {
  ChildEnd end;
  const auto limit = ChildClock::now() + std::chrono::seconds(program.limit_s);
  bool open = true;
  while (open) {
    // Whoever it has started may still hold its output.
    if (::waitpid(process, &end.status, WNOHANG) == process) process = 0;
    pollfd readable = {output, POLLIN, 0};
    const int ready = ::poll(&readable, 1, process == 0 ? 0 : kOutputWaitMs);
    if (ready > 0) {
      char buffer[16384];
      const ssize_t count = ::read(output, buffer, sizeof buffer);
      if (count > 0) Keep({buffer, static_cast<size_t>(count)}, &end.output);
      open = count > 0 || (count < 0 && errno == EINTR);
    } else if (process == 0) {
      open = false;
    }
    if (program.limit_s > 0 && ChildClock::now() >= limit) {
      if (process != 0) {
        end.out_of_time = true;
        ::kill(process, SIGKILL);
      }
      open = false;
    }
  }
  while (process != 0 && ::waitpid(process, &end.status, 0) < 0 && errno == EINTR) {
  }
  return end;
}

}  // namespace

void DieWithParent(int parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it has ended before
}

Result<ChildEnd> RunChild(const ChildProgram& program) {
  int output[2] = {-1, -1};
  int failure[2] = {-1, -1};
  const pid_t self = ::getpid();
  const bool piped = ::pipe2(output, O_CLOEXEC) == 0 && ::pipe2(failure, O_CLOEXEC) == 0;
  const pid_t process = piped ? ::fork() : -1;
  int error = process < 0 ? errno : 0;
  if (process == 0) Become(program, self, output[1], failure[1]);
  ::close(output[1]);
  ::close(failure[1]);
  ChildEnd end;
  if (process > 0) {
    // Closed without a word when the program begins.
    while (::read(failure[0], &error, sizeof error) < 0 && errno == EINTR) {
    }
    end = ReadToEnd(program, process, output[0]);
  }
  ::close(output[0]);
  ::close(failure[0]);
  if (error == 0) return end;
  return MakeError(1, "cannot run '{0}': {1}", "无法运行“{0}”：{1}", program.words.front(),
                   std::strerror(error));
}

}  // namespace oncard::tools
