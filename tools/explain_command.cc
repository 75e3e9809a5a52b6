// oncard explain: the page of a diagnostic.
#include <charconv>

#include "compiler/explain.h"
#include "tools/commands.h"

namespace oncard::tools {
namespace {

// `MP027`, `mp27` or `27`; -1 for anything else.
int ParseCode(std::string_view text) {
  if (text.size() > 2 && (text[0] == 'M' || text[0] == 'm') && (text[1] == 'P' || text[1] == 'p')) {
    text.remove_prefix(2);
  }
  int code = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), code);
  return error == std::errc() && end == text.data() + text.size() ? code : -1;
}

int ListCodes() {
  std::string list;
  for (const compiler::DiagnosticInfo& info : compiler::DiagnosticTable()) {
    list += fmt::format("{}  {}\n", compiler::DiagnosticName(info.code), info.slug);
  }
  PrintResult(list);
  return kExitOk;
}

int Explain(const std::string& name, const Session& session) {
  if (name.empty()) return ListCodes();
  const auto page = compiler::ExplainPage(ParseCode(name), session.language);
  if (!page) {
    return Fail(session, kExitUsage,
                MakeMessage("no diagnostic is named '{0}': 'oncard explain' lists them all",
                            "没有名为“{0}”的诊断：“oncard explain”列出全部", name));
  }
  PrintResult(*page);
  return kExitOk;
}

}  // namespace

void AddExplain(CLI::App& app, Session& session) {
  const auto name = std::make_shared<std::string>();
  CLI::App* command = AddCommand(app, session, "explain",
                                 {"explain a diagnostic, with a program that has it and its repair",
                                  "解释一条诊断，附出错程序及其修改"},
                                 [name, &session] { return Explain(*name, session); });
  command
      ->add_option("code", *name,
                   session.Say({"such as MP027; without it all codes are listed",
                                "如 MP027；省略则列出全部代码"}))
      ->type_name("CODE");
}

}  // namespace oncard::tools
