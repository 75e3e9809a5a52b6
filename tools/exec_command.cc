// oncard exec: a host program in virtual time.
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "runtime/clock.h"
#include "runtime/key_script.h"
#include "runtime/scenario.h"
#include "tools/commands.h"

namespace oncard::tools {
namespace {

constexpr const char* kPreloadLibrary = "liboncard_host.so";

struct ExecArguments {
  std::vector<std::string> host;
  std::string scenario;
  std::string keys;
  std::string clock = "virtual";
};

/// The folder of libgts and the preload library: beside the command, or in ../lib.
std::string LibraryFolder() {
  std::error_code error;
  const auto binary = std::filesystem::read_symlink("/proc/self/exe", error);
  for (const auto& folder : {binary.parent_path(), binary.parent_path().parent_path() / "lib"}) {
    if (std::filesystem::exists(folder / kPreloadLibrary, error)) return folder.string();
  }
  return {};
}

/// Adds a value to a list of the environment, at its front or its end.
void ExtendList(const char* name, const std::string& value, const char* separator, bool front) {
  const char* old = std::getenv(name);
  std::string list = value;
  if (old != nullptr && *old != '\0') {
    list = front ? value + separator + old : old + std::string(separator) + value;
  }
  ::setenv(name, list.c_str(), 1);
}

int Exec(const ExecArguments& arguments, const Session& session) {
  const auto clock = runtime::ParseClockSetting(arguments.clock);
  if (!clock.ok()) {
    return Fail(session, kExitUsage,
                MakeMessage("--clock is '{}', expected virtual, real or real:SCALE",
                            "--clock 为“{}”，应为 virtual、real 或 real:倍率", arguments.clock));
  }
  const auto keys = runtime::ParseKeyScript(arguments.keys);
  if (!keys.ok()) return Fail(session, kExitUsage, keys.error().message);
  if (!arguments.scenario.empty()) {
    const auto scenario = runtime::LoadWorld(arguments.scenario);
    if (!scenario.ok()) return Fail(session, kExitUnreadable, scenario.error().message);
    ::setenv("ONCARD_SCENARIO", arguments.scenario.c_str(), 1);
  }
  if (!arguments.keys.empty()) ::setenv("ONCARD_KEYS", arguments.keys.c_str(), 1);
  ::setenv("ONCARD_CLOCK", arguments.clock.c_str(), 1);

  const std::string folder = LibraryFolder();
  if (folder.empty()) {
    return Fail(
        session, kExitUnreadable,
        MakeMessage("{0} is neither beside oncard nor in ../lib; install it there",
                    "{0} 不在 oncard 旁，也不在 ../lib 中；请将其安装到该处", kPreloadLibrary));
  }
  ExtendList("LD_LIBRARY_PATH", folder, ":", false);
  if (clock.value().kind == runtime::ClockKind::kVirtual) {
    ExtendList("LD_PRELOAD", folder + "/" + kPreloadLibrary, ":", true);
  }
  std::vector<std::string> host = arguments.host;
  std::vector<char*> pointers;
  for (std::string& argument : host) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  ::execvp(pointers[0], pointers.data());
  return Fail(
      session, kExitUnreadable,
      MakeMessage("cannot run '{0}': {1}", "无法运行“{0}”：{1}", host[0], std::strerror(errno)));
}

}  // namespace

void AddExec(CLI::App& app, Session& session) {
  const auto arguments = std::make_shared<ExecArguments>();
  CLI::App* command = AddCommand(app, session, "exec",
                                 {"run a host program in virtual time", "以虚拟时间运行主机程序"},
                                 [arguments, &session] { return Exec(*arguments, session); });
  command
      ->add_option(
          "host", arguments->host,
          session.Say({"the program and its arguments, after --", "程序及其参数，写在 -- 之后"}))
      ->required()
      ->type_name("HOST");
  command
      ->add_option("--scenario", arguments->scenario,
                   session.Say({"the card's world and what is expected (docs/scenarios.md)",
                                "卡的外部世界与期望（docs/scenarios.md）"}))
      ->type_name("FILE");
  command
      ->add_option("--keys", arguments->keys,
                   session.Say({"keys to press, as in 500:a,1000:q (at 500 ms, at 1000 ms)",
                                "要按的键，如 500:a,1000:q（500 ms、1000 ms 时）"}))
      ->type_name("KEYS");
  command
      ->add_option("--clock", arguments->clock,
                   session.Say({"virtual (default), real or real:SCALE",
                                "virtual（默认）、real 或 real:倍率"}))
      ->type_name("CLOCK");
}

}  // namespace oncard::tools
