// In place of eni_file.cc in a build without the XML library, such as libgts for hosts of 32 bits.
#include "runtime/host/eni_file.h"

namespace oncard::runtime {

Result<motion::bus::Slaves> ParseEni(std::string_view, const std::string& path) {
  return MakeError(1, "{0}: this build of the library reads no ENI files; use [[ethercat.slave]]",
                   "{0}：此版本的库不能读取 ENI 文件；请使用 [[ethercat.slave]]", path);
}

}  // namespace oncard::runtime
