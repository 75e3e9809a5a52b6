#include "tools/invocation.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>

#include "base/files.h"
#include "compiler/diagnostic_printer.h"
#include "compiler/display_text.h"

namespace oncard::tools {

void PrintResult(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

void PrintDiagnostics(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

int Fail(const Invocation& invocation, int code, const Message& message) {
  std::string text;
  std::istringstream lines(invocation.Say(message));
  for (std::string line; std::getline(lines, line);) text += compiler::DisplayText(line) + '\n';
  PrintDiagnostics("oncard: " + text);
  return code;
}

int FinishOutput(const Invocation& invocation, int code) {
  const bool flushed = std::fflush(stdout) == 0;
  const std::string why = flushed ? std::string() : fmt::format(": {}", std::strerror(errno));
  if (!flushed || std::ferror(stdout) != 0) {
    return Fail(invocation, kExitUnreadable,
                MakeMessage("cannot write to standard output{0}", "无法写入标准输出{0}", why));
  }
  // There is no output left for an error message.
  return std::ferror(stderr) != 0 ? static_cast<int>(kExitUnreadable) : code;
}

int WriteOutput(const Invocation& invocation, const std::string& path, std::string_view content) {
  return WriteOutput(invocation, path, SourceOf(content));
}

int WriteOutput(const Invocation& invocation, const std::string& path, TextSource content) {
  const auto written = WriteFileAtomically(path, std::move(content));
  return written.ok() ? kExitOk : Fail(invocation, kExitUnreadable, written.error().message);
}

int LoadOrReport(const Invocation& invocation, const std::string& path,
                 const compiler::Options& options, bool json, runtime::ProgramLoad* load) {
  *load = runtime::LoadProgram(path, options);
  if (load->error) return Fail(invocation, kExitUnreadable, load->error->message);
  if (load->compilation) {
    const compiler::PrintOptions print = {invocation.language, invocation.color};
    PrintDiagnostics(json ? compiler::PrintJson(*load->compilation, print)
                          : compiler::PrintText(*load->compilation, print));
  }
  return load->object ? kExitOk : kExitFailed;
}

vm::DoubleFormat DoubleFormatOf(std::string_view text) {
  return text == "16.16" ? vm::DoubleFormat::k16_16 : vm::DoubleFormat::k32_16;
}

}  // namespace oncard::tools
