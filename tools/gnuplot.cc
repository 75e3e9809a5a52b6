#include "tools/gnuplot.h"

#include <optional>
#include <vector>

#include "tools/filter.h"

namespace oncard::tools {
namespace {

// Runs gnuplot with these options on a script; empty if it cannot be started.
std::optional<FilterRun> RunGnuplot(const std::vector<std::string>& options,
                                    const std::string& script) {
  std::vector<std::string> words = {"gnuplot"};
  words.insert(words.end(), options.begin(), options.end());
  auto run = RunFilter(words, script);
  if (!run || run->good) return run;
  if (run->err.empty()) run->err = "gnuplot failed";
  run->out.clear();
  return run;
}

}  // namespace

std::string GnuplotVersion() {
  const auto run = RunGnuplot({"--version"}, {});
  if (!run) return {};
  return run->out.substr(0, run->out.find('\n'));
}

int WritePicture(const Invocation& invocation, const std::string& path, const std::string& script) {
  // -d: without the user's initialisation file.
  const auto run = RunGnuplot({"-d", "-"}, script);
  if (!run) return Fail(invocation, kExitUnreadable, GnuplotRemedy());
  if (run->out.empty()) {
    return Fail(invocation, kExitInternal, MakeMessage("gnuplot: {0}", "gnuplot：{0}", run->err));
  }
  return WriteOutput(invocation, path, run->out);
}

}  // namespace oncard::tools
