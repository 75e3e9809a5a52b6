#include "runtime/observe/trace_file.h"

#include "runtime/observe/plot.h"

namespace oncard::runtime {
namespace {

constexpr std::string_view kScript = ".gnuplot";

}  // namespace

bool IsTraceName(std::string_view path) {
  return path.ends_with(".csv") || path.ends_with(".vcd") || path.ends_with(".json") ||
         path.ends_with(kScript);
}

Result<std::string> TraceText(const Trace& trace, std::string_view path, const std::string& title) {
  if (path.ends_with(".vcd")) return trace.Vcd();
  if (path.ends_with(".json")) return trace.Json();
  if (!path.ends_with(kScript)) return trace.Csv();
  path.remove_suffix(kScript.size());
  const bool png = path.ends_with(".png");
  return PlotScript(trace, {title, png ? PictureFormat::kPng : PictureFormat::kSvg});
}

}  // namespace oncard::runtime
