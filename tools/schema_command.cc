// oncard schema: the keys of scenario files for editors, and the session protocol for clients.
#include "runtime/scenario/file/scenario_schema.h"
#include "session/protocol_schema.h"
#include "tools/commands.h"

namespace oncard::tools {

void AddSchema(CLI::App& app, Invocation& invocation) {
  auto protocol = std::make_shared<bool>(false);
  CLI::App* command =
      AddCommand(app, invocation, "schema",
                 {"print the JSON Schema of scenario files, for editors",
                  "输出场景文件的 JSON Schema，供编辑器使用"},
                 [protocol, &invocation] {
                   PrintResult(*protocol ? session::ProtocolSchema()
                                         : runtime::ScenarioSchema(invocation.language));
                   return kExitOk;
                 });
  command->add_flag("--protocol", *protocol,
                    invocation.Say({"that of the session protocol instead, for clients",
                                    "改为输出会话协议的 JSON Schema，供客户端使用"}));
}

}  // namespace oncard::tools
