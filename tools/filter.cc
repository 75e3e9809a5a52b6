#include "tools/filter.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <memory>

namespace oncard::tools {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// An unnamed file with `content`, positioned at its beginning.
File Scratch(const std::string& content) {
  File file(std::tmpfile());
  if (!file) return nullptr;
  const bool written =
      std::fwrite(content.data(), 1, content.size(), file.get()) == content.size() &&
      std::fflush(file.get()) == 0;
  std::rewind(file.get());
  return written ? std::move(file) : nullptr;
}

std::string ReadAll(std::FILE* file) {
  std::rewind(file);
  std::string content;
  std::array<char, 65536> buffer;
  for (size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), file)) > 0;) {
    content.append(buffer.data(), count);
  }
  return content;
}

}  // namespace

std::optional<FilterRun> RunFilter(const std::vector<std::string>& words, const std::string& text) {
  const File in = Scratch(text);
  const File out = Scratch({});
  const File err = Scratch({});
  if (!in || !out || !err) return std::nullopt;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(in.get()), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(out.get()), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(err.get()), STDERR_FILENO);
  std::vector<std::string> arguments = words;
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  const int failure =
      ::posix_spawnp(&process, pointers[0], &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return std::nullopt;
  int status = 0;
  if (::waitpid(process, &status, 0) != process) return std::nullopt;
  return FilterRun{ReadAll(out.get()), ReadAll(err.get()),
                   WIFEXITED(status) && WEXITSTATUS(status) == 0};
}

}  // namespace oncard::tools
