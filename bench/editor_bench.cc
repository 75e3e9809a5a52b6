// `oncard_bench editor`: how long each request about a source takes, for 1000 lines of the card's
// language and of structured C. CPU time of a request to its answer as text.
#include <algorithm>
#include <cstdio>
#include <string>

#include "bench/measure.h"
#include "session/arguments.h"
#include "session/editor_requests.h"
#include "session/host.h"

namespace oncard::bench {
namespace {

constexpr int kFunctions = 25;

struct EditedProgram {
  const char* name;
  std::string text;
  bool structured;
};

/// 40 lines for each function.
EditedProgram CardSource() {
  std::string text;
  for (int f = 0; f < kFunctions; ++f) {
    const std::string n = std::to_string(f);
    text +=
        "int total" + n + ";\nint f" + n + "(int first)\n{\n  int i, cc;\n  i = first;\nloop:\n";
    for (int i = 0; i < 15; ++i) {
      text += "  total" + n + " = total" + n + " + i;\n  GT_SetPos(1, total" + n + ");\n";
    }
    text += "  cc = i > 10;\n  if (cc) return i;\n  goto loop;\n}\n";
  }
  return {"1000 lines of the card's language", std::move(text), false};
}

EditedProgram StructuredSource() {
  std::string text = "#define STEP(x) ((x) * 2 + 1)\n";
  for (int f = 0; f < kFunctions; ++f) {
    const std::string n = std::to_string(f);
    text +=
        "int total" + n + ";\nint f" + n + "(int first)\n{\n  for (int i = first; i < 10; ++i) {\n";
    for (int i = 0; i < 16; ++i) {
      text += "    total" + n + " += i * STEP(i);\n    GT_SetPos(1, total" + n + " + i);\n";
    }
    text += "  }\n  return total" + n + ";\n}\n";
  }
  return {"1000 lines of structured C", std::move(text), true};
}

void BenchRequest(session::SessionHost& host, const EditedProgram& source,
                  const session::RequestText& request) {
  session::Json arguments = {
      {"main", "p.c"}, {"files", {{"p.c", source.text}}}, {"structured", source.structured}};
  if (request.arguments.find("line") != std::string_view::npos) {
    // The `total24` of an argument in the last function.
    const size_t offset = source.text.rfind("GT_SetPos(1, total") + 14;
    const size_t line_begin = source.text.rfind('\n', offset) + 1;
    arguments["line"] =
        std::count(source.text.begin(), source.text.begin() + static_cast<std::ptrdiff_t>(offset),
                   '\n') +
        1;
    arguments["column"] = offset - line_begin + 1;
  }
  if (request.name == "rename") arguments["name"] = "sum";
  const session::Json message = {
      {"id", 1}, {"request", request.name}, {"arguments", std::move(arguments)}};
  const std::string text = message.dump();
  size_t bytes = 0;
  const double seconds = MeasureCpu([&] {
    const std::string answer = host.Handle(text);
    if (answer.find("\"ok\":true") == std::string::npos) Fail(answer);
    bytes = answer.size();
  });
  std::printf("  %-12s %8.2f ms  %8zu bytes\n", std::string(request.name).c_str(), seconds * 1e3,
              bytes);
}

}  // namespace

void BenchEditor() {
  session::SessionHost host;
  for (const EditedProgram& source : {CardSource(), StructuredSource()}) {
    std::printf("%s\n", source.name);
    BenchRequest(host, source, {"check", "main"});
    for (const session::EditorRequest& each : session::EditorRequests()) {
      if (each.text.name == "lower" && !source.structured) continue;
      BenchRequest(host, source, each.text);
    }
  }
}

}  // namespace oncard::bench
