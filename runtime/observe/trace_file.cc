#include "runtime/observe/trace_file.h"

#include <functional>
#include <utility>

#include "runtime/observe/plot.h"

namespace oncard::runtime {
namespace {

constexpr std::string_view kScript = ".gnuplot";

}  // namespace

bool IsTraceName(std::string_view path) {
  return path.ends_with(".csv") || path.ends_with(".vcd") || path.ends_with(".json") ||
         path.ends_with(kScript);
}

Result<TextSource> TraceText(const Trace& trace, std::string_view path, const std::string& title) {
  if (path.ends_with(".vcd")) return TextSource(std::bind_front(&Trace::WriteVcd, &trace));
  if (path.ends_with(".json")) return TextSource(std::bind_front(&Trace::WriteJson, &trace));
  if (!path.ends_with(kScript)) return TextSource(std::bind_front(&Trace::WriteCsv, &trace));
  path.remove_suffix(kScript.size());
  auto script = PictureScript(trace, path, title);
  if (!script.ok()) return script.error();
  return TextSource([text = std::move(script).value()](const TextSink& sink) { sink(text); });
}

Result<std::string> PictureScript(const Trace& trace, std::string_view path,
                                  const std::string& title) {
  const bool png = path.ends_with(".png");
  return PlotScript(trace, {title, png ? PictureFormat::kPng : PictureFormat::kSvg});
}

}  // namespace oncard::runtime
