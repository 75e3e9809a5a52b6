// oncard verify: reports whether a card would load these objects, and if not, why.
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "runtime/sim/controller.h"
#include "tools/commands.h"
#include "vm/object_reader.h"
#include "vm/verifier.h"

namespace oncard::tools {
namespace {

// The code that GT_Download returns for a missing file.
constexpr int kNoSuchFile = 2007;

struct VerifyArguments {
  std::vector<std::string> paths;
  std::string format = "text";
};

Result<void> VerifyObject(const std::string& path) {
  const auto object = vm::ReadObjectPair(path);
  if (!object.ok()) return object.error();
  const runtime::Controller controller;
  return vm::Verify(object.value(), controller.commands());
}

int VerifyAll(const VerifyArguments& arguments, const Invocation& invocation) {
  int code = kExitOk;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const std::string& path : arguments.paths) {
    const auto verified = VerifyObject(path);
    nlohmann::ordered_json item = {{"file", path}, {"accepted", verified.ok()}};
    if (!verified.ok()) {
      const Error& error = verified.error();
      item["code"] = error.code;
      item["reason"] = invocation.Say(error.message);
      const int exit_code = error.code == kNoSuchFile ? kExitUnreadable : kExitFailed;
      code = std::max(code, exit_code);
      if (arguments.format == "text") {
        Fail(invocation, exit_code,
             MakeMessage("{0}: refused with code {1}: {2}", "{0}：拒绝，返回值 {1}：{3}", path,
                         error.code, error.message.en, error.message.zh));
      }
    }
    list.push_back(std::move(item));
  }
  if (arguments.format == "json") {
    PrintResult(JsonText(list, 2) + '\n');
  }
  return code;
}

}  // namespace

void AddVerify(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* command =
      AddCommand(app, invocation, "verify",
                 {"check an object and say why a card would reject it", "说明目标文件被拒绝的原因"},
                 [arguments, &invocation] { return VerifyAll(*arguments, invocation); });
  command
      ->add_option("objects", arguments->paths,
                   invocation.Say({"objects (.bin), each with its .ini beside it",
                                   "目标文件（.bin），其 .ini 在同一文件夹"}))
      ->required()
      ->type_name("FILE");
  AddFormatOption(*command, invocation, arguments->format, {"text", "json"});
}

}  // namespace oncard::tools
