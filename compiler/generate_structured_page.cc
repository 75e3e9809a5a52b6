// Renews docs/structured.md and its translation: every code block after a line `<!-- lowered -->`
// becomes what the code block before it is lowered to.
#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <string_view>

#include "base/files.h"
#include "compiler/lowering/lowering.h"

namespace oncard::compiler {
namespace {

constexpr std::string_view kMark = "<!-- lowered -->";
constexpr std::string_view kFence = "```";

Result<std::string> NoFile(const std::string& path) {
  return MakeError(kNoSuchFile, "no file '{}'", "没有文件“{}”", path);
}

Result<std::string> LowerBlock(const std::string& program) {
  const Lowering lowering = LowerText("program.c", program, {}, {true, true}, NoFile);
  if (lowering.text && lowering.diagnostics.empty()) return *lowering.text;
  const Diagnostic& first = lowering.diagnostics.front();
  return MakeError(1, "{}: {}\n{}", "{}：{}\n{}", DiagnosticName(first.info->code),
                   first.message.en, program);
}

Result<std::string> Renew(std::string_view page) {
  std::string out;
  std::string block;  // the last one that was read
  bool inside = false;
  bool marked = false;
  while (!page.empty()) {
    const size_t end = page.find('\n');
    const std::string_view line = page.substr(0, end);
    page.remove_prefix(end == std::string_view::npos ? page.size() : end + 1);
    if (line == kMark) marked = true;
    if (line.starts_with(kFence)) {
      inside = !inside;
      if (inside && marked) {
        const Result<std::string> lowered = LowerBlock(block);
        if (!lowered.ok()) return lowered.error();
        out += fmt::format("{}\n{}", line, lowered.value());
        continue;
      }
      if (inside) block.clear();
      if (!inside) marked = false;
    } else if (inside) {
      if (marked) continue;
      block += fmt::format("{}\n", line);
    }
    out += fmt::format("{}\n", line);
  }
  return out;
}

int Main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: generate_structured_page PAGE OUTPUT\n");
    return 2;
  }
  const Result<std::string> page = ReadFile(argv[1], kSourceKind);
  const Result<std::string> renewed = page.ok() ? Renew(page.value()) : page.error();
  if (!renewed.ok()) {
    fmt::print(stderr, "generate_structured_page: {}\n", renewed.error().message.en);
    return 1;
  }
  if (auto written = WriteFileAtomically(argv[2], renewed.value()); !written.ok()) {
    fmt::print(stderr, "generate_structured_page: {}\n", written.error().message.en);
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace oncard::compiler

int main(int argc, char** argv) { return oncard::compiler::Main(argc, argv); }
