// oncard check: reports diagnostics, or applies their fix-its with --fix. Text goes to standard
// error like all diagnostics; JSON and SARIF are the requested output, so they go to standard
// output.
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/limits.h"
#include "compiler/diagnostic_printer.h"
#include "compiler/fix_it_applier.h"
#include "tools/commands.h"
#include "tools/compile_arguments.h"

namespace oncard::tools {
namespace {

// The name for standard input on the command line; in messages it is kStandardInputName.
constexpr std::string_view kStandardInput = "-";
constexpr std::string_view kStandardInputName = "<stdin>";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

struct CheckOptions {
  std::vector<std::string> sources;
  bool fix = false;
  CompileArguments compile;
  std::string diagnostics = "text";
};

Result<std::string> ReadStandardInput() {
  std::string text;
  char part[4096];
  size_t count = 0;
  while ((count = std::fread(part, 1, sizeof part, stdin)) > 0) {
    text.append(part, count);
    if (text.size() > kSourceKind.bytes_max) {
      return MakeError(kExitUnreadable, "standard input has more than {} bytes",
                       "标准输入超过 {} 字节", kSourceKind.bytes_max);
    }
  }
  if (std::ferror(stdin) != 0) {
    return MakeError(kExitUnreadable, "cannot read standard input: {}", "无法读取标准输入：{}",
                     std::strerror(errno));
  }
  return text;
}

Result<std::string> ReadSource(const std::string& source) {
  return source == kStandardInput ? ReadStandardInput() : compiler::ReadSource(source);
}

// Writes the corrected text: files in place, standard input to standard output.
int WriteCorrected(const compiler::CorrectedProgram& corrected, const std::string& name,
                   const std::string& text, const Invocation& invocation) {
  int code = kExitOk;
  for (const auto& [path, content] : corrected.files) {
    if (path == kStandardInputName) continue;
    const auto before = compiler::ReadSource(path);
    const bool marked = before.ok() && before.value().starts_with(kByteOrderMark);
    code = std::max(
        code, WriteOutput(invocation, path, (marked ? std::string(kByteOrderMark) : "") + content));
  }
  if (name == kStandardInputName) {
    const auto found = corrected.files.find(name);
    PrintResult(found != corrected.files.end() ? found->second : text);
  } else if (corrected.count > 0) {
    PrintDiagnostics(fmt::format(
        "{}\n", invocation.Say(MakeMessage("{0}: fix-its applied: {1}", "{0}：修改了 {1} 处", name,
                                           corrected.count))));
  }
  return code;
}

// Compiles one source, and corrects it if requested. Empty if it cannot be read.
std::optional<compiler::Compilation> CheckOne(const CheckOptions& options,
                                              const compiler::Options& compile,
                                              const std::string& source,
                                              const Invocation& invocation, int* code) {
  Result<std::string> text = ReadSource(source);
  if (!text.ok()) {
    *code = std::max<int>(*code, Fail(invocation, kExitUnreadable, text.error().message));
    return std::nullopt;
  }
  const std::string name(source == kStandardInput ? kStandardInputName : source);
  const bool structured = compiler::IsStructured(compile, text.value());
  if (options.fix && structured) {
    *code = std::max<int>(
        *code,
        Fail(invocation, kExitUsage,
             MakeMessage("--fix rewrites C as the card's language; '{0}' is structured C, which "
                         "stays as it is: use 'oncard lower' for a program of the card's language",
                         "--fix 把 C 改写为控制卡的语言；“{0}”是结构化 C，无需改写："
                         "要得到控制卡语言的程序，请用“oncard lower”",
                         name)));
    return std::nullopt;
  }
  if (!options.fix) {
    return compiler::CompileText(name, std::move(text).value(), compile, compiler::ReadSource);
  }
  compiler::CorrectedProgram corrected =
      compiler::ApplyAllFixIts(name, text.value(), compile, compiler::ReadSource);
  *code = std::max(*code, WriteCorrected(corrected, name, text.value(), invocation));
  return std::move(corrected.compilation);
}

int Check(const CheckOptions& options, const Invocation& invocation) {
  const compiler::Options compile = OptionsOf(options.compile);
  const compiler::PrintOptions print = {invocation.language, invocation.color};
  int code = kExitOk;
  const bool corrects_input =
      options.fix && std::find(options.sources.begin(), options.sources.end(), kStandardInput) !=
                         options.sources.end();
  if (corrects_input && options.diagnostics != "text") {
    return Fail(invocation, kExitUsage,
                MakeMessage("--fix - writes the program to standard output: leave out --format",
                            "--fix - 把程序写到标准输出：请去掉 --format"));
  }
  std::vector<compiler::Compilation> compilations;
  for (const std::string& source : options.sources) {
    if (source.ends_with(".bin")) {
      code = std::max<int>(code, Fail(invocation, kExitUsage,
                                      MakeMessage("'{0}' is an object: use 'oncard verify'",
                                                  "“{0}”是目标文件：请用“oncard verify”", source)));
      continue;
    }
    auto compilation = CheckOne(options, compile, source, invocation, &code);
    if (!compilation) continue;
    if (!compilation->ok()) code = std::max<int>(code, kExitFailed);
    if (options.diagnostics == "text") {
      PrintDiagnostics(compiler::PrintText(*compilation, print));
    } else if (options.diagnostics == "json") {
      PrintResult(compiler::PrintJson(*compilation, print));
    }
    compilations.push_back(std::move(*compilation));
  }
  if (options.diagnostics == "sarif") PrintResult(compiler::PrintSarif(compilations, print));
  return code;
}

}  // namespace

void AddCheck(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = AddCommand(app, invocation, "check",
                                 {"report errors and warnings of programs, correct them on request",
                                  "检查程序并报告问题，可自动修改"},
                                 [options, &invocation] { return Check(*options, invocation); });
  command
      ->add_option("sources", options->sources,
                   invocation.Say({"motion programs (.c); - is standard input",
                                   "运动程序（.c）；- 表示标准输入"}))
      ->required()
      ->type_name("FILE");
  command->add_flag(
      "--fix", options->fix,
      invocation.Say({"apply all fix-its in place; with -, print the corrected program",
                      "就地应用所有修改建议；- 的结果写到标准输出"}));
  AddCompileOptions(*command, invocation, options->compile);
  command
      ->add_option("--diagnostics,--format", options->diagnostics,
                   invocation.Say(
                       {"format of the diagnostics: text|json|sarif", "诊断格式：text|json|sarif"}))
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"text", "json", "sarif"}).description(""));
}

}  // namespace oncard::tools
