// oncard serve: the playground of this computer, with the engine of this command behind it.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <thread>

#include "base/files.h"
#include "tools/commands.h"
#include "tools/page_server.h"
#include "tools/project_session.h"
#include "tools/stop_signals.h"

namespace oncard::tools {
namespace {

/// How soon a signal ends the command.
constexpr std::chrono::milliseconds kPatience{50};

struct ServeArguments {
  std::string page;
  int port = 0;
};

/// Where an installation has the page.
std::string InstalledPage() {
  std::error_code error;
  const auto binary = std::filesystem::read_symlink("/proc/self/exe", error);
  return (binary.parent_path().parent_path() / "share/oncard/page").string();
}

bool HasPage(const std::string& folder) { return FileExists(folder + "/index.html"); }

int Serve(const ServeArguments& arguments, const Invocation& invocation) {
  const std::string folder = arguments.page.empty() ? InstalledPage() : arguments.page;
  if (!HasPage(folder)) {
    return Fail(
        invocation, kExitUnreadable,
        MakeMessage("there is no page in '{0}': name its folder with --page; './x demo-web' "
                    "in oncard's sources builds it in web/playground/dist/page",
                    "“{0}”中没有页面：请用 --page 指定其文件夹；在 oncard 源码目录运行 "
                    "'./x demo-web' 会将其构建到 web/playground/dist/page",
                    folder));
  }
  const std::string token = RandomToken();
  PageServer server(folder, token, NewProjectSession, invocation.language);
  const auto port = server.Bind(arguments.port);
  if (!port.ok()) return Fail(invocation, kExitUnreadable, port.error().message);
  const StopSignals signals;
  std::atomic<bool> failed = false;
  std::thread thread([&server, &failed] {
    try {
      server.Serve();
    } catch (const std::system_error&) {  // a thread for connections cannot be started
    }
    failed = true;
  });
  PrintResult(fmt::format("http://127.0.0.1:{}/{}/?engine=here\n", port.value(), token));
  int code = FinishOutput(invocation, kExitOk);
  while (code == kExitOk && !signals.stopped() && !failed) std::this_thread::sleep_for(kPatience);
  if (failed) {
    code = Fail(invocation, kExitUnreadable,
                {"the server accepts no more connections", "服务器无法再接受连接"});
  }
  // Sessions keep nothing outside of memory, so requests that are being answered are not waited
  // for.
  std::_Exit(FinishOutput(invocation, code));
}

}  // namespace

void AddServe(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<ServeArguments>();
  CLI::App* command = AddCommand(
      app, invocation, "serve",
      {"show the playground with this command as its engine, on this computer only, until Ctrl-C",
       "在本机显示练习页面，由本命令作为其引擎，直到按 Ctrl-C"},
      [arguments, &invocation] { return Serve(*arguments, invocation); });
  command
      ->add_option("--page", arguments->page,
                   invocation.Say({"folder of the page (default: share/oncard/page of the "
                                   "installation)",
                                   "页面所在的文件夹（默认：安装目录下的 share/oncard/page）"}))
      ->type_name("FOLDER");
  command
      ->add_option("--port", arguments->port,
                   invocation.Say({"port on 127.0.0.1; 0 (default) = one that is free",
                                   "127.0.0.1 上的端口；0（默认）表示任意空闲端口"}))
      ->type_name("N")
      ->check(CLI::Range(0, 65535).description(""));
}

}  // namespace oncard::tools
