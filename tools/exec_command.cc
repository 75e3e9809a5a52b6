// oncard exec: runs a host program in virtual time.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "base/files.h"
#include "gtcalls/families.h"
#include "gtcalls/family.h"
#include "runtime/host/host_card.h"
#include "runtime/host/host_clock.h"
#include "runtime/scenario/file/key_script.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/record/call_record.h"
#include "runtime/scenario/run/choices.h"
#include "tools/commands.h"
#include "tools/gbk_output.h"
#include "tools/gnuplot.h"
#include "tools/host_program.h"

namespace oncard::tools {
namespace {

struct ExecArguments {
  std::vector<std::string> host;
  std::string scenario;
  std::string keys;
  std::string clock = "virtual";
  std::string card;
  std::string trace;
  std::string plot;
  std::string record;
  bool gbk = false;
  bool strict_commands = false;
  std::vector<std::string> silent;
};

/// The message about a missing library; empty if none is missing.
Message MissingLibrary(const LibraryFolders& folders, const std::string& host) {
  if (folders.own.empty()) {
    return MakeMessage("{0} is neither beside oncard nor in ../lib; install it there",
                       "{0} 不在 oncard 旁，也不在 ../lib 中；请将其安装到该处", kPreloadLibrary);
  }
  if (folders.of32bits.empty() && IsProgramOf32Bits(host)) {
    return MakeMessage(
        "'{0}' is a 32-bit program, and there is no 32-bit {1} in ../lib32 beside oncard; "
        "'./x host32' in oncard's sources builds it, or compile the host without -m32",
        "“{0}”是 32 位程序，而 oncard 旁的 ../lib32 中没有 32 位的 {1}；在 oncard 源码目录运行 "
        "'./x host32' 可构建它，或编译主机程序时不加 -m32",
        host, kPreloadLibrary);
  }
  return {};
}

/// Adds a value to a list in an environment variable, at its front or its end.
void ExtendList(const char* name, const std::string& value, const char* separator, bool front) {
  const char* old = std::getenv(name);
  std::string list = value;
  if (old != nullptr && *old != '\0') {
    list = front ? value + separator + old : old + std::string(separator) + value;
  }
  ::setenv(name, list.c_str(), 1);
}

/// The file to which the host library writes the gnuplot script.
std::string ScriptPath(const ExecArguments& arguments) { return arguments.plot + ".gnuplot"; }

/// Sets what the host library writes: the trace, the gnuplot script, the record. The host may
/// change its working directory.
void RequestFiles(const ExecArguments& arguments) {
  const auto absolute = [](const std::string& path) {
    std::error_code error;
    return std::filesystem::absolute(path, error).string();
  };
  std::string files;
  if (!arguments.trace.empty()) files = absolute(arguments.trace);
  if (!arguments.plot.empty()) files += ':' + absolute(ScriptPath(arguments));
  if (!files.empty()) ::setenv("ONCARD_TRACE", files.c_str(), 1);
  if (!arguments.record.empty()) {
    ::setenv("ONCARD_RECORD", absolute(arguments.record).c_str(), 1);
  }
}

/// Replaces an old record, so that none is left if the host opens no card. Fails if it cannot be
/// written, or has no name of a record.
Result<void> PrepareRecord(const std::string& path) {
  if (!path.ends_with(runtime::kCallRecordEnding)) {
    return MakeError(kExitUsage, "--record is '{0}'; the name of a record ends in {1}",
                     "--record 为“{0}”；记录的文件名以 {1} 结尾", path, runtime::kCallRecordEnding);
  }
  auto written = WriteFileAtomically(path, runtime::FormatRecordHead());
  if (!written.ok()) return Error{kExitUnreadable, written.error().message};
  return {};
}

/// The host to which signals are forwarded; 0: they end the command.
volatile pid_t host_process = 0;

extern "C" void HandOn(int signal) { ::kill(host_process, signal); }

/// The signal goes to the host, which then writes its gnuplot script before it ends.
void HandSignalsOn(pid_t process) {
  host_process = process;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    static_cast<void>(std::signal(signal, process == 0 ? SIG_DFL : HandOn));
  }
}

/// Starts the host with `output` as its standard output (-1: the command's own). Returns the error
/// number.
int Start(char* const* host, int output, pid_t* process) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  if (output >= 0) ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  const int failure = ::posix_spawnp(process, host[0], &actions, nullptr, host, environ);
  ::posix_spawn_file_actions_destroy(&actions);
  return failure;
}

/// Draws the script that a host with that exit code has written; returns the code unless drawing
/// fails.
int Draw(const ExecArguments& arguments, int code, const Invocation& invocation) {
  const auto script = ReadFile(ScriptPath(arguments));
  if (!script.ok()) return code != 0 ? code : Fail(invocation, kExitFailed, script.error().message);
  std::error_code ignored;
  std::filesystem::remove(ScriptPath(arguments), ignored);
  ::unsetenv("LD_PRELOAD");  // gnuplot uses the real time
  const int drawn = WritePicture(invocation, arguments.plot, script.value());
  return code != 0 ? code : drawn;
}

/// Runs the host to its end, converts its output to UTF-8 and draws, as far as requested. Returns
/// the host's exit code, unless one of the others fails.
int RunToEnd(const ExecArguments& arguments, char* const* host, const Invocation& invocation) {
  int output[2] = {-1, -1};
  if (arguments.gbk && ::pipe2(output, O_CLOEXEC) != 0) return kExitInternal;
  pid_t process = 0;
  const int failure = Start(host, output[1], &process);
  if (failure != 0) {
    return Fail(invocation, kExitUnreadable,
                MakeMessage("cannot run '{0}': {1}", "无法运行“{0}”：{1}", host[0],
                            std::strerror(failure)));
  }
  HandSignalsOn(process);
  Result<void> relayed;
  if (arguments.gbk) {
    ::close(output[1]);
    relayed = RelayGbk(output[0], STDOUT_FILENO);
    ::close(output[0]);
  }
  int status = 0;
  while (::waitpid(process, &status, 0) != process) {
    if (errno != EINTR) return kExitInternal;
  }
  HandSignalsOn(0);
  int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (!relayed.ok() && code == 0) code = Fail(invocation, kExitFailed, relayed.error().message);
  return arguments.plot.empty() ? code : Draw(arguments, code, invocation);
}

int Exec(const ExecArguments& arguments, const Invocation& invocation) {
  const auto clock = runtime::ParseClockSetting(arguments.clock);
  if (!clock.ok()) {
    return Fail(invocation, kExitUsage,
                MakeMessage("--clock is '{}', expected virtual, real or real:SCALE",
                            "--clock 为“{}”，应为 virtual、real 或 real:倍率", arguments.clock));
  }
  const auto keys = runtime::ParseKeyScript(arguments.keys);
  if (!keys.ok()) return Fail(invocation, kExitUsage, keys.error().message);
  if (!arguments.card.empty()) ::setenv("ONCARD_CARD", arguments.card.c_str(), 1);
  const auto card = runtime::CardFromEnvironment(nullptr);
  if (!card.ok()) return Fail(invocation, kExitUsage, card.error().message);
  if (!arguments.scenario.empty()) {
    const auto scenario =
        runtime::LoadScenario(arguments.scenario, runtime::ScenarioUse::kHost, card.value());
    if (!scenario.ok()) return Fail(invocation, kExitUnreadable, scenario.error().message);
    const auto choices = runtime::Choices::Of(scenario.value());
    if (!choices.ok()) return Fail(invocation, kExitUnreadable, choices.error().message);
    ::setenv("ONCARD_SCENARIO", arguments.scenario.c_str(), 1);
  }
  if (!arguments.record.empty()) {
    const auto ready = PrepareRecord(arguments.record);
    if (!ready.ok()) return Fail(invocation, ready.error().code, ready.error().message);
  }
  RequestFiles(arguments);
  // Not LC_ALL, which would change the host's own texts.
  ::setenv("ONCARD_LANG", invocation.language == Language::kChinese ? "zh" : "en", 1);
  ::setenv("ONCARD_REFUSALS", arguments.strict_commands ? "strict" : "warn", 1);
  const std::string silent = fmt::to_string(fmt::join(arguments.silent, ","));
  ::setenv("ONCARD_SILENT", silent.c_str(), 1);
  if (!arguments.keys.empty()) ::setenv("ONCARD_KEYS", arguments.keys.c_str(), 1);
  ::setenv("ONCARD_CLOCK", arguments.clock.c_str(), 1);

  // main() ignores it, and a started program would inherit that.
  static_cast<void>(std::signal(SIGXFSZ, SIG_DFL));
  const LibraryFolders folders = FindLibraries();
  const Message missing = MissingLibrary(folders, arguments.host.front());
  if (!missing.en.empty()) return Fail(invocation, kExitUnreadable, missing);
  ExtendList("LD_LIBRARY_PATH", folders.own, ":", false);
  if (!folders.of32bits.empty()) ExtendList("LD_LIBRARY_PATH", folders.of32bits, ":", false);
  if (clock.value().kind == runtime::ClockKind::kVirtual) {
    // A library without a path is searched for in those folders. So every program, including those
    // started by the host or a shell, loads the library with its own word length.
    ExtendList("LD_PRELOAD", kPreloadLibrary, ":", true);
  }
  std::vector<std::string> host = arguments.host;
  std::vector<char*> pointers;
  pointers.reserve(host.size() + 1);
  for (std::string& argument : host) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  if (arguments.gbk) ::setenv("ONCARD_LINES", "1", 1);
  if (!arguments.plot.empty() || arguments.gbk) {
    return RunToEnd(arguments, pointers.data(), invocation);
  }
  ::execvp(pointers[0], pointers.data());
  return Fail(
      invocation, kExitUnreadable,
      MakeMessage("cannot run '{0}': {1}", "无法运行“{0}”：{1}", host[0], std::strerror(errno)));
}

}  // namespace

void AddExec(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<ExecArguments>();
  CLI::App* command = AddCommand(app, invocation, "exec",
                                 {"run a host program in virtual time", "以虚拟时间运行主机程序"},
                                 [arguments, &invocation] { return Exec(*arguments, invocation); });
  command
      ->add_option(
          "host", arguments->host,
          invocation.Say({"the program and its arguments, after --", "程序及其参数，写在 -- 之后"}))
      ->required()
      ->type_name("HOST");
  command
      ->add_option("--scenario", arguments->scenario,
                   invocation.Say(
                       {"scenario: the card, its surroundings, what must hold (docs/scenarios.md)",
                        "场景：控制卡、外部世界与应成立的条件（docs/scenarios.md）"}))
      ->type_name("FILE");
  command
      ->add_option("--keys", arguments->keys,
                   invocation.Say({"keys to press, as in 500:a,1000:q (at 500 ms, at 1000 ms)",
                                   "要按的键，如 500:a,1000:q（500 ms、1000 ms 时）"}))
      ->type_name("KEYS");
  command
      ->add_option("--clock", arguments->clock,
                   invocation.Say({"virtual (default), real or real:SCALE",
                                   "virtual（默认）、real 或 real:倍率"}))
      ->type_name("CLOCK");
  const auto card_names = gtcalls::CardTypeNames();
  std::vector<std::string_view> defaults;
  for (const gtcalls::Family* family : gtcalls::Families()) {
    defaults.push_back(family->default_card.name);
  }
  command
      ->add_option("--card", arguments->card,
                   invocation.Say(MakeMessage("type of the cards: {0} (without a scenario {1})",
                                              "控制卡型号：{0}（没有场景时为 {1}）",
                                              fmt::to_string(fmt::join(card_names, ", ")),
                                              fmt::to_string(fmt::join(defaults, ", ")))))
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(card_names), std::end(card_names)))
                  .description(""))
      ->type_name("CARD");
  command->add_flag("--gbk", arguments->gbk,
                    invocation.Say({"convert the output of the host from GBK to UTF-8",
                                    "将主机程序以 GBK 输出的文字转为 UTF-8"}));
  command
      ->add_option("--trace", arguments->trace,
                   invocation.Say({"write values over time, as .vcd, .csv, .json or .gnuplot",
                                   "写出随时间变化的值，格式为 .vcd、.csv、.json 或 .gnuplot"}))
      ->type_name("FILE")
      ->check(CLI::Validator(CheckTraceName, ""));
  command
      ->add_option("--plot", arguments->plot,
                   invocation.Say({"draw values over time, as .svg or .png (needs gnuplot)",
                                   "绘制随时间变化的曲线，格式为 .svg 或 .png（需要 gnuplot）"}))
      ->type_name("FILE")
      ->check(CLI::Validator(CheckPictureName, ""));
  command
      ->add_option(
          "--record", arguments->record,
          invocation.Say({"write the calls of the host, for oncard debug and oncard replay",
                          "写出主机程序的调用，供 oncard debug 和 oncard replay 使用"}))
      ->type_name("FILE");
  AddStrictCommandsOption(*command, invocation, arguments->strict_commands);
  AddSilentOption(*command, invocation, arguments->silent);
}

}  // namespace oncard::tools
