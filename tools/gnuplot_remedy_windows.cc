#include "tools/gnuplot.h"

namespace oncard::tools {

Message GnuplotRemedy() {
  return {"gnuplot is not found: install it (http://www.gnuplot.info), with its folder bin in PATH",
          "找不到 gnuplot：请安装（http://www.gnuplot.info），并将其 bin 文件夹加入 PATH"};
}

}  // namespace oncard::tools
