// oncard explain: shows the page of a diagnostic or of structured C, or lists the diagnostics about
// a word.
#include "compiler/explain.h"
#include "compiler/explain_search.h"
#include "compiler/lowering/overview.h"
#include "tools/commands.h"

#include <fmt/format.h>

namespace oncard::tools {
namespace {

int ListCodes() {
  std::string list;
  for (const compiler::DiagnosticInfo& info : compiler::DiagnosticTable()) {
    list += fmt::format("{}  {}\n", compiler::DiagnosticName(info.code), info.slug);
  }
  PrintResult(list);
  return kExitOk;
}

int Explain(const std::vector<std::string>& words, const Invocation& invocation) {
  const std::string text = fmt::format("{}", fmt::join(words, " "));
  if (text.empty()) return ListCodes();
  if (text == compiler::kStructuredTopic) {
    PrintResult(compiler::StructuredOverview(invocation.language));
    return kExitOk;
  }
  const std::vector<int> codes = compiler::SearchDiagnostics(text);
  if (codes.empty()) return Fail(invocation, kExitUsage, compiler::AdviseSearch(text));
  PrintResult(codes.size() == 1 ? *compiler::ExplainPage(codes[0], invocation.language)
                                : compiler::ExplainList(codes, invocation.language));
  return kExitOk;
}

}  // namespace

void AddExplain(CLI::App& app, Invocation& invocation) {
  const auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      AddCommand(app, invocation, "explain",
                 {"explain a diagnostic, with a program that causes it and its correction",
                  "解释一条诊断，附出错程序及其修改"},
                 [words, &invocation] { return Explain(*words, invocation); });
  command
      ->add_option(
          "code", *words,
          invocation.Say({"number (27), name (undeclared) or words (goto); without it all "
                          "codes are listed",
                          "编号（27）、名称（undeclared）或词（goto）；省略则列出全部代码"}))
      ->type_name("CODE");
}

}  // namespace oncard::tools
