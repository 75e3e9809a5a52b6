// In WebAssembly, which starts no other programs.
#include "tools/gnuplot.h"

namespace oncard::tools {

std::string GnuplotVersion() { return {}; }

Message GnuplotRemedy() {
  return {
      "the oncard of npm draws no pictures: write --trace FILE.gnuplot and give it to gnuplot, "
      "or install oncard",
      "npm 版 oncard 不绘图：请用 --trace 文件.gnuplot 写出后交给 gnuplot，或安装 oncard"};
}

int WritePicture(const Invocation& invocation, const std::string& /*path*/,
                 const std::string& /*script*/) {
  return Fail(invocation, kExitUnreadable, GnuplotRemedy());
}

}  // namespace oncard::tools
