#include "tools/gnuplot.h"

namespace oncard::tools {

Message GnuplotRemedy() {
  return {
      "the oncard of npm draws no pictures: write --trace FILE.gnuplot and give it to gnuplot, "
      "or install oncard",
      "npm 版 oncard 不绘图：请用 --trace 文件.gnuplot 写出后交给 gnuplot，或安装 oncard"};
}

}  // namespace oncard::tools
