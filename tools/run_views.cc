#include "tools/run_views.h"

#include <algorithm>
#include <utility>

#include "base/milliseconds.h"
#include "explore/reports/step_table.h"
#include "runtime/observe/trace_file.h"
#include "tools/gnuplot.h"
#include "tools/terminal.h"

namespace oncard::tools {
namespace {

/// What the card did by itself, one line each.
std::string FormatEvents(const runtime::Trace& trace, const Invocation& invocation) {
  std::string text;
  for (const runtime::TraceMark& mark : trace.marks()) {
    if (!mark.by_card) continue;
    text += fmt::format("{} ms  {}\n", ToMs(mark.time_us), invocation.Say(mark.text));
  }
  if (text.empty()) return text;
  return invocation.Say({"what the card did by itself:\n", "控制卡自身的动作：\n"}) + text;
}

/// The run statement by statement, with a column per thread (explore/reports/step_table.h).
std::string FormatSteps(const runtime::ScenarioResult& result, const explore::ProgramText& source,
                        bool full, const Invocation& invocation) {
  const runtime::StepLog& log = *result.steps;
  if (log.steps.empty()) return {};
  explore::Subject subject;
  subject.image = log.image;
  std::vector<explore::TrailStep> steps;
  for (const runtime::ThreadReport& thread : result.threads) {
    const int function = vm::FindFunction(*log.image, thread.function);
    subject.threads.push_back({thread.thread, function, thread.page});
  }
  for (const runtime::LoggedStep& step : log.steps) {
    const auto found =
        std::ranges::find(subject.threads, step.thread, &explore::ThreadSetup::thread);
    if (found == subject.threads.end()) continue;  // it has been unbound since
    steps.push_back({static_cast<int>(found - subject.threads.begin()), step});
  }
  explore::StepView view = {subject, steps, source};
  view.detail = full ? explore::Detail::kFull : explore::Detail::kLoops;
  view.with_card = true;
  view.trace = result.trace ? &*result.trace : nullptr;
  std::string text = explore::TextTable(view, OutputWidth(), invocation.language);
  if (log.executed > static_cast<int64_t>(log.steps.size())) {
    text += invocation.Say(MakeMessage("these are the first {0} of {1} statements\n",
                                       "以上为 {1} 条语句中的前 {0} 条\n", log.steps.size(),
                                       log.executed));
  }
  if (result.trace) text += FormatEvents(*result.trace, invocation);
  return text + '\n';
}

}  // namespace

void AddViewOptions(CLI::App& command, const Invocation& invocation, RunViews& views) {
  command.add_flag(
      "--steps", views.steps,
      invocation.Say({"print what every statement reads and writes, one column per thread",
                      "列出每条语句的读写，每个线程一列"}));
  command.add_flag(
      "--full", views.full,
      invocation.Say({"with --steps: show every pass of a loop", "与 --steps 合用：循环逐次列出"}));
  command
      .add_option("--trace", views.trace,
                  invocation.Say({"write values over time, as .vcd, .csv, .json or .gnuplot",
                                  "写出随时间变化的值，格式为 .vcd、.csv、.json 或 .gnuplot"}))
      ->type_name("FILE")
      ->check(CLI::Validator(CheckTraceName, ""));
  command
      .add_option("--plot", views.plot,
                  invocation.Say({"draw values over time, as .svg or .png (needs gnuplot)",
                                  "绘制随时间变化的曲线，格式为 .svg 或 .png（需要 gnuplot）"}))
      ->type_name("FILE")
      ->check(CLI::Validator(CheckPictureName, ""));
}

void ApplyViews(const RunViews& views, runtime::RunOptions* options) {
  options->steps = views.steps;
  options->trace = views.steps || !views.trace.empty() || !views.plot.empty();
}

void PrintSteps(const runtime::ScenarioResult& result, const runtime::ProgramLoad& load,
                const RunViews& views, const std::string& format, const Invocation& invocation) {
  if (!result.steps || format != "text") return;
  explore::ProgramText source;
  if (load.compilation) source = explore::TextOf(*load.compilation);
  PrintResult(FormatSteps(result, source, views.full, invocation));
}

int WriteViews(const runtime::ScenarioResult& result, const RunViews& views,
               const std::string& title, const Invocation& invocation) {
  int code = kExitOk;
  if (!views.trace.empty()) {
    auto text = runtime::TraceText(*result.trace, views.trace, title);
    if (!text.ok()) return Fail(invocation, kExitFailed, text.error().message);
    code = WriteOutput(invocation, views.trace, std::move(text).value());
  }
  if (!views.plot.empty()) {
    const auto script = runtime::PictureScript(*result.trace, views.plot, title);
    if (!script.ok()) return Fail(invocation, kExitFailed, script.error().message);
    code = std::max(code, WritePicture(invocation, views.plot, script.value()));
  }
  return code;
}

}  // namespace oncard::tools
