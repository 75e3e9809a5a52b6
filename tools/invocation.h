// Common parts of all subcommands: the language, colours, the exit code, and the two output
// streams. Results go to standard output, diagnostics to standard error.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/message.h"
#include "base/result.h"
#include "base/text_pieces.h"
#include "compiler/compiler.h"
#include "runtime/sim/program.h"

namespace oncard::tools {

enum ExitCode : int {
  kExitOk = 0,
  kExitFailed = 1,
  kExitUsage = 2,
  kExitUnreadable = 3,
  kExitInternal = 4,
  kExitBounded = 5,
  kExitIncomplete = 6,
};

/// The meaning of an exit code, for the help and the manual page.
struct ExitCodeText {
  ExitCode code;
  std::string_view meaning_en;
  std::string_view meaning_zh;
};

inline constexpr std::array kExitCodeTexts = {
    ExitCodeText{kExitOk, "success", "一切正常"},
    ExitCodeText{kExitFailed, "the program, the test or the replay failed", "程序、测试或重放失败"},
    ExitCodeText{kExitUsage, "the command line is wrong, or a name in it is unknown",
                 "命令行或其中的名称有误"},
    ExitCodeText{kExitUnreadable, "a file cannot be read or written", "文件无法读写"},
    ExitCodeText{kExitInternal, "internal error: a bug in oncard", "oncard 自身的错误"},
    ExitCodeText{kExitBounded, "no failure up to the bound of the search", "在搜索范围内没有错误"},
    ExitCodeText{kExitIncomplete,
                 "a limit or the end of memory was reached, or the command was interrupted, before "
                 "it was complete",
                 "达到上限、内存耗尽或被中断而未完成"},
};

struct Invocation {
  Language language = Language::kEnglish;
  bool color = false;
  int exit_code = kExitOk;

  /// The text in the invocation's language.
  const std::string& Say(const Message& message) const { return message.In(language); }
};

/// Writes to standard output. FinishOutput() reports whether everything was written.
void PrintResult(std::string_view text);
/// Writes to standard error.
void PrintDiagnostics(std::string_view text);
/// To be called once at the end. Returns `code`, or kExitUnreadable with a report if output to
/// standard output or standard error was lost.
int FinishOutput(const Invocation& invocation, int code);
/// Reports `oncard: message` on standard error and returns `code`. Unprintable bytes in a line of
/// the message (names can contain any bytes) show as `<1B>`.
int Fail(const Invocation& invocation, int code, const Message& message);

/// Writes a file; reports a failure. Returns the exit code.
int WriteOutput(const Invocation& invocation, const std::string& path, std::string_view content);
/// The same for content that is made while it is written.
int WriteOutput(const Invocation& invocation, const std::string& path, TextSource content);

/// Loads a program and reports its diagnostics in the chosen format (`text` or `json`). Returns the
/// exit code; the object is present if that is kExitOk.
int LoadOrReport(const Invocation& invocation, const std::string& path,
                 const compiler::Options& options, bool json, runtime::ProgramLoad* load);

/// Reads `32.16` or `16.16`, which the option has checked.
vm::DoubleFormat DoubleFormatOf(std::string_view text);

}  // namespace oncard::tools
