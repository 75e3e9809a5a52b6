// oncard lower: structured C in, the card's language out.
#include "compiler/diagnostic_printer.h"
#include "compiler/lowering/lowering.h"
#include "compiler/lowering/two_columns.h"
#include "tools/commands.h"
#include "tools/compile_arguments.h"
#include "tools/terminal.h"

namespace oncard::tools {
namespace {

struct LowerOptions {
  std::string source;
  std::string output;
  compiler::LoweringOptions lowering;
  bool cost = false;
  bool diff = false;
  int width = 0;  // 0: that of the terminal
  CompileArguments compile;
  std::string diagnostics = "text";
};

// A table of what each thread function takes, its calls that are jumps, and the globals.
std::string CostTable(const compiler::Lowering& lowering, const Invocation& invocation) {
  const auto row = [](const auto&... cells) {
    return fmt::format("{:<32}{:>12}{:>8}{:>13}{:>12}\n", cells...);
  };
  std::string text =
      row(invocation.Say({"function", "函数"}), invocation.Say({"statements", "语句"}),
          invocation.Say({"labels", "标号"}), invocation.Say({"temporaries", "临时变量"}),
          invocation.Say({"page slots", "页存储单元"}));
  for (const compiler::FunctionCost& cost : lowering.costs) {
    text += row(cost.name, cost.statements, cost.labels, cost.temporaries, cost.page_slots);
  }
  for (const compiler::FunctionCost& cost : lowering.costs) {
    for (const compiler::JumpCalls& jumps : cost.jumps) {
      text += fmt::format("{}\n", invocation.Say(MakeMessage("{0}: {1} calls of {2} are jumps",
                                                             "{0}：对 {2} 的 {1} 次调用为跳转",
                                                             cost.name, jumps.calls, jumps.name)));
    }
  }
  for (const compiler::FunctionCost& cost : lowering.costs) {
    for (const compiler::FramesCost& frames : cost.frames) {
      text += fmt::format("{}\n",
                          invocation.Say(MakeMessage(
                              "{0}: {1} calls of {2} may wait, which takes {3} page slots",
                              "{0}：{2} 最多有 {1} 次调用在等待，占用 {3} 个页存储单元", cost.name,
                              frames.count, frames.name, frames.count * frames.slots)));
    }
  }
  for (const compiler::FunctionCost& cost : lowering.costs) {
    for (const compiler::SharedSlotsCost& shared : cost.shared_slots) {
      text += fmt::format(
          "{}\n", invocation.Say(MakeMessage(
                      "{0}: the slots of {1} are those of {2}, too; their lives do not overlap",
                      "{0}：{1} 的存储单元也由 {2} 使用；它们的生命期不重叠", cost.name,
                      shared.name, fmt::to_string(fmt::join(shared.others, ", ")))));
    }
    for (const std::string& table : cost.tables) {
      text += fmt::format(
          "{}\n", invocation.Say(MakeMessage("{0}: the constants of {1} are in its page",
                                             "{0}：{1} 的常量位于它的数据页", cost.name, table)));
    }
  }
  return text +
         fmt::format("{}\n", invocation.Say(MakeMessage("global slots: {0}", "全局存储单元：{0}",
                                                        lowering.global_slots)));
}

// What the command writes; nothing if there is an error.
std::string Shown(const compiler::Lowering& lowering, const LowerOptions& options,
                  const Invocation& invocation) {
  if (!lowering.text) return {};
  if (!options.diff) return *lowering.text;
  const bool to_file = !options.output.empty();
  compiler::TwoColumnsOptions columns;
  if (options.width > 0) {
    columns.width = options.width;
  } else if (const int width = to_file ? 0 : OutputWidth(); width > 0) {
    columns.width = width;
  }
  columns.color = invocation.color && !to_file;
  return compiler::FormatTwoColumns(lowering, columns);
}

int Lower(const LowerOptions& options, const Invocation& invocation) {
  if (!options.output.empty() && options.output == options.source) {
    return Fail(invocation, kExitUsage,
                MakeMessage("the output '{0}' is the source: give it another name",
                            "输出“{0}”就是源文件：请换一个名称", options.output));
  }
  if (options.width > 0 && !options.diff) {
    return Fail(invocation, kExitUsage,
                MakeMessage("--width sets the columns of --diff: add --diff, or leave it out",
                            "--width 设置 --diff 的列数：请加上 --diff，或去掉它"));
  }
  compiler::LoweringOptions how = options.lowering;
  how.comments = !options.diff;
  Result<std::string> text = compiler::ReadSource(options.source);
  if (!text.ok()) return Fail(invocation, kExitUnreadable, text.error().message);
  compiler::Lowering lowering =
      compiler::LowerText(options.source, std::move(text).value(), OptionsOf(options.compile), how,
                          compiler::ReadSource);
  const std::string output = Shown(lowering, options, invocation);
  const compiler::Compilation report = compiler::TakeCompilation(lowering);
  const compiler::PrintOptions print = {invocation.language, invocation.color};
  PrintDiagnostics(options.diagnostics == "json" ? compiler::PrintJson(report, print)
                                                 : compiler::PrintText(report, print));
  if (!lowering.text) return kExitFailed;
  if (options.cost) PrintDiagnostics(CostTable(lowering, invocation));
  if (!options.output.empty()) return WriteOutput(invocation, options.output, output);
  PrintResult(output);
  return kExitOk;
}

}  // namespace

void AddLower(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<LowerOptions>();
  CLI::App* command =
      AddCommand(app, invocation, "lower",
                 {"translate structured C to the card's language", "把结构化 C 转换为控制卡的语言"},
                 [options, &invocation] { return Lower(*options, invocation); });
  command
      ->add_option("source", options->source,
                   invocation.Say({"program in structured C (.c)", "结构化 C 程序（.c）"}))
      ->required()
      ->type_name("FILE");
  command
      ->add_option("-o,--output", options->output,
                   invocation.Say({"file of the lowered program (default: standard output)",
                                   "转换结果的文件（默认：标准输出）"}))
      ->type_name("FILE");
  command->add_flag(
      "--diff", options->diff,
      invocation.Say({"show C beside the lowered program, each statement in the rows of those that "
                      "it became",
                      "并排显示 C 与转换结果，每条 C 语句位于由它得到的各条语句所在的行"}));
  command
      ->add_option("--width", options->width,
                   invocation.Say({"columns of --diff (default: those of the terminal, or 120)",
                                   "--diff 的列数（默认：终端的列数，或 120）"}))
      ->check(CLI::Range(compiler::kTwoColumnsMin, compiler::kTwoColumnsMax).description(""))
      ->type_name("N");
  command->add_flag(
      "--annotate", options->lowering.annotate,
      invocation.Say({"mark statements of C that read and write a global in different "
                      "statements of the card, and calls that are jumps",
                      "标出在不同的卡语句中读写同一全局变量的 C 语句，以及成为跳转的调用"}));
  command->add_flag("--optimize,!--no-optimize", options->lowering.optimize,
                    invocation.Say({"shorten the program (default)", "精简程序（默认）"}));
  command->add_flag("--cost", options->cost,
                    invocation.Say({"print what each function takes, and which calls are jumps, to "
                                    "standard error",
                                    "把各函数的占用情况以及哪些调用为跳转写到标准错误"}));
  AddCompileOptions(*command, invocation, options->compile, false);
  AddDiagnosticsOption(*command, invocation, options->diagnostics);
}

}  // namespace oncard::tools
