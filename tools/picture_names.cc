// Names of pictures and traces, whose endings say what they are.
#include "runtime/observe/trace_file.h"
#include "tools/gnuplot.h"

namespace oncard::tools {

std::string CheckPictureName(const std::string& path) {
  if (path.ends_with(".svg") || path.ends_with(".png")) return {};
  return "the name must end in .svg or .png";
}

std::string CheckTraceName(const std::string& path) {
  if (runtime::IsTraceName(path)) return {};
  return "the name must end in .vcd, .csv, .json or .gnuplot";
}

}  // namespace oncard::tools
