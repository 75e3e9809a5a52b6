#include "tools/gnuplot.h"

namespace oncard::tools {

Message GnuplotRemedy() {
  return {"gnuplot is not installed: apt-get install gnuplot-nox",
          "未安装 gnuplot：apt-get install gnuplot-nox"};
}

}  // namespace oncard::tools
