#include "tests/tools/process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <utility>

#include "base/files.h"

namespace oncard::tools {
namespace {

std::vector<char*> Pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

namespace {

std::vector<std::string> OncardCommand(const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {ONCARD_BUILD_DIR "/bin/oncard"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

/// True if the process has a handler for the signal.
bool Catches(pid_t process, int signal) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("SigCgt:")) continue;
    return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0;
  }
  return false;
}

bool HasEnded(pid_t process) {
  siginfo_t info{};
  ::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT);
  return info.si_pid != 0;
}

/// Starts a program whose output goes into two files. 0 if it cannot be started.
pid_t Start(std::vector<std::string> command, const std::string& folder,
            const std::vector<std::string>& environment, const std::string& out,
            const std::string& err) {
  // The first definition of a variable is used.
  std::vector<std::string> variables = environment;
  variables.insert(variables.end(),
                   {"LANG=C", "PATH=/usr/bin:/bin", "ASAN_OPTIONS=detect_leaks=0"});

  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  constexpr int kFlags = O_WRONLY | O_CREAT | O_TRUNC;
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), kFlags, 0600);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), kFlags, 0600);
  if (!folder.empty()) ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::vector<char*> argument_pointers = Pointers(command);
  std::vector<char*> variable_pointers = Pointers(variables);
  pid_t process = 0;
  const int failure = ::posix_spawnp(&process, command[0].c_str(), &actions, nullptr,
                                     argument_pointers.data(), variable_pointers.data());
  ::posix_spawn_file_actions_destroy(&actions);
  return failure == 0 ? process : 0;
}

/// Waits for the end of a process; 128 plus the number of the signal that ended it.
int ExitCodeOf(pid_t process) {
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Runs a program; `watch` is called with the process while it runs.
template <typename Watch>
ProcessResult RunWatched(const std::vector<std::string>& command, const std::string& folder,
                         const std::vector<std::string>& environment, Watch watch) {
  const ScratchFolder scratch;
  const pid_t process =
      Start(command, folder, environment, scratch.path() + "/out", scratch.path() + "/err");
  ProcessResult result;
  if (process == 0) return result;
  watch(process);
  result.exit_code = ExitCodeOf(process);
  result.out = scratch.Read("out");
  result.err = scratch.Read("err");
  return result;
}

}  // namespace

ProcessResult RunOncard(const std::vector<std::string>& arguments, const std::string& folder,
                        const std::vector<std::string>& environment) {
  return RunProgram(OncardCommand(arguments), folder, environment);
}

ProcessResult RunProgram(const std::vector<std::string>& command, const std::string& folder,
                         const std::vector<std::string>& environment) {
  return RunWatched(command, folder, environment, [](pid_t) {});
}

ProcessResult InterruptOncard(const std::vector<std::string>& arguments, int signal,
                              const std::string& folder) {
  return RunWatched(OncardCommand(arguments), folder, {}, [signal](pid_t process) {
    while (!Catches(process, signal) && !HasEnded(process)) ::usleep(1000);
    ::kill(process, signal);
  });
}

RunningOncard::RunningOncard(const std::vector<std::string>& arguments, const std::string& copy) {
  std::vector<std::string> command = OncardCommand(arguments);
  if (!copy.empty()) command.front() = copy;
  process_ = Start(command, {}, {}, scratch_.path() + "/out", scratch_.path() + "/err");
}

RunningOncard::~RunningOncard() {
  if (process_ != 0) Stop(SIGKILL);
}

std::string RunningOncard::FirstLine() const {
  for (;;) {
    const bool ended = process_ == 0 || HasEnded(process_);
    const std::string out = scratch_.Read("out");
    const size_t end = out.find('\n');
    if (end != std::string::npos || ended) return out.substr(0, end);
    ::usleep(1000);
  }
}

int RunningOncard::Stop(int signal) {
  ::kill(process_, signal);
  return ExitCodeOf(std::exchange(process_, 0));
}

ScratchFolder::ScratchFolder() {
  std::string pattern = testing::TempDir() + "oncard_XXXXXX";
  path_ = ::mkdtemp(pattern.data());
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string ScratchFolder::Write(const std::string& name, const std::string& content) const {
  const std::filesystem::path path = path_ / name;
  std::filesystem::create_directories(path.parent_path());
  EXPECT_TRUE(WriteFileAtomically(path.string(), content).ok());
  return path.string();
}

std::string ScratchFolder::Read(const std::string& name) const {
  auto content = ReadFile((path_ / name).string());
  return content.ok() ? content.value() : "";
}

bool ScratchFolder::Has(const std::string& name) const {
  return std::filesystem::exists(path_ / name);
}

void ExpectGolden(const std::string& name, const std::string& actual) {
  const std::string path = std::string(ONCARD_SOURCE_DIR "/tests/tools/golden/") + name;
  if (std::getenv("ONCARD_REBASE") != nullptr) {
    ASSERT_TRUE(WriteFileAtomically(path, actual).ok());
    return;
  }
  const auto expected = ReadFile(path);
  ASSERT_TRUE(expected.ok()) << expected.error().message.en;
  EXPECT_EQ(actual, expected.value()) << path;
}

}  // namespace oncard::tools
