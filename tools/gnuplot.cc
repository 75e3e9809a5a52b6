#include "tools/gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "runtime/observe/trace_file.h"

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

struct GnuplotRun {
  std::string out;
  std::string err;
};

// Runs gnuplot with these options on a script; empty if it cannot be started.
std::optional<GnuplotRun> RunGnuplot(const std::vector<std::string>& options,
                                     const std::string& script) {
  const File in = Scratch(script);
  const File out = Scratch({});
  const File err = Scratch({});
  if (!in || !out || !err) return std::nullopt;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(in.get()), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(out.get()), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(err.get()), STDERR_FILENO);
  std::vector<std::string> arguments = {"gnuplot"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  const int failure =
      ::posix_spawnp(&process, "gnuplot", &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return std::nullopt;
  int status = 0;
  if (::waitpid(process, &status, 0) != process) return std::nullopt;
  GnuplotRun run{ReadAll(out.get()), ReadAll(err.get())};
  const bool good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!good && run.err.empty()) run.err = "gnuplot failed";
  if (!good) run.out.clear();
  return run;
}

}  // namespace

std::string GnuplotVersion() {
  const auto run = RunGnuplot({"--version"}, {});
  if (!run) return {};
  return run->out.substr(0, run->out.find('\n'));
}

Message GnuplotRemedy() {
  return {"gnuplot is not installed: apt-get install gnuplot-nox",
          "未安装 gnuplot：apt-get install gnuplot-nox"};
}

int WritePicture(const Invocation& invocation, const std::string& path, const std::string& script) {
  // -d: without the user's initialisation file.
  const auto run = RunGnuplot({"-d", "-"}, script);
  if (!run) return Fail(invocation, kExitUnreadable, GnuplotRemedy());
  if (run->out.empty()) {
    return Fail(invocation, kExitInternal, MakeMessage("gnuplot: {0}", "gnuplot：{0}", run->err));
  }
  return WriteOutput(invocation, path, run->out);
}

std::string CheckPictureName(const std::string& path) {
  if (path.ends_with(".svg") || path.ends_with(".png")) return {};
  return "the name must end in .svg or .png";
}

std::string CheckTraceName(const std::string& path) {
  if (runtime::IsTraceName(path)) return {};
  return "the name must end in .vcd, .csv, .json or .gnuplot";
}

}  // namespace oncard::tools
