// oncard schema: the keys of scenario files for editors.
#include "runtime/scenario/scenario_schema.h"
#include "tools/commands.h"

namespace oncard::tools {

void AddSchema(CLI::App& app, Invocation& invocation) {
  AddCommand(app, invocation, "schema",
             {"print the JSON Schema of scenario files, for editors",
              "输出场景文件的 JSON Schema，供编辑器使用"},
             [&invocation] {
               PrintResult(runtime::ScenarioSchema(invocation.language));
               return kExitOk;
             });
}

}  // namespace oncard::tools
