// oncard explain: shows the page of a diagnostic, of a return code or of structured C, or lists the
// diagnostics about a word.
#include "base/number.h"
#include "compiler/explain.h"
#include "compiler/explain_search.h"
#include "compiler/lowering/overview.h"
#include "gtcalls/gts/return_codes.h"
#include "tools/commands.h"

#include <fmt/format.h>

namespace oncard::tools {
namespace {

int ListCodes() {
  std::string list;
  for (const compiler::DiagnosticInfo& info : compiler::DiagnosticTable()) {
    list += fmt::format("{}  {}\n", compiler::DiagnosticName(info.code), info.slug);
  }
  for (const runtime::CardWarningInfo& info : runtime::CardWarningTable()) {
    list += fmt::format("card   {}\n", info.name);
  }
  PrintResult(list);
  return kExitOk;
}

/// The page of a warning of the card's supervisor.
std::string CardPage(const runtime::CardWarningInfo& info, Language language) {
  const bool chinese = language == Language::kChinese;
  std::string page =
      fmt::format("{} ({})\n\n", info.name, chinese ? "运行警告" : "warning of runs");
  compiler::AppendWrapped(page, chinese ? info.zh : info.en, "    ");
  page += '\n';
  compiler::AppendWrapped(page, chinese ? info.why_zh : info.why_en, "");
  return page;
}

int Explain(const std::vector<std::string>& words, const Invocation& invocation) {
  const std::string text = fmt::format("{}", fmt::join(words, " "));
  if (text.empty()) return ListCodes();
  if (text == compiler::kStructuredTopic) {
    PrintResult(compiler::StructuredOverview(invocation.language));
    return kExitOk;
  }
  if (const runtime::CardWarningInfo* info = runtime::FindCardWarning(text)) {
    PrintResult(CardPage(*info, invocation.language));
    // A warning of the compiler may have the same name.
    for (const compiler::DiagnosticInfo& diagnostic : compiler::DiagnosticTable()) {
      if (diagnostic.slug != text) continue;
      PrintResult('\n' + *compiler::ExplainPage(diagnostic.code, invocation.language));
    }
    return kExitOk;
  }
  // A number can be both, but with MP in front of it only a diagnostic.
  std::optional<Message> return_code;
  if (const auto number = ReadWhole<int>(text)) return_code = gtcalls::gts::ReturnCodePage(*number);
  if (return_code) PrintResult(return_code->In(invocation.language));
  const std::vector<int> codes = compiler::SearchDiagnostics(text);
  if (return_code && !codes.empty()) PrintResult("\n");
  if (return_code && codes.empty()) return kExitOk;
  if (codes.empty()) return Fail(invocation, kExitUsage, compiler::AdviseSearch(text));
  PrintResult(codes.size() == 1 ? *compiler::ExplainPage(codes[0], invocation.language)
                                : compiler::ExplainList(codes, invocation.language));
  return kExitOk;
}

}  // namespace

void AddExplain(CLI::App& app, Invocation& invocation) {
  const auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = AddCommand(
      app, invocation, "explain",
      {"explain a diagnostic or the return code of a GT command", "解释一条诊断或 GT 指令的返回值"},
      [words, &invocation] { return Explain(*words, invocation); });
  command
      ->add_option(
          "code", *words,
          invocation.Say(
              {"number (27), name (undeclared), words (goto) or return code (7, -6); "
               "without it all codes are listed",
               "编号（27）、名称（undeclared）、词（goto）或返回值（7、-6）；省略则列出全部代码"}))
      ->type_name("CODE");
}

}  // namespace oncard::tools
