// A host whose global object uses the card when the process exits.
#include <cstdio>
#include <initializer_list>

#include "gts.h"

namespace {

struct MachineOfHost {
  MachineOfHost() = default;
  MachineOfHost(const MachineOfHost&) = delete;
  MachineOfHost& operator=(const MachineOfHost&) = delete;
  ~MachineOfHost() {
    double position = 0;
    short function = 0;
    char* version = nullptr;
    TCompileInfo info = {};
    int failed = 0;
    for (const short code :
         {GT_GetPrfPos(1, &position), GT_Stop(1, 0), GT_AxisOff(1), GT_GetVersion(&version),
          GT_Compile(const_cast<char*>("sum.c"), &info), GT_Download(const_cast<char*>("sum.bin")),
          GT_GetFunId(const_cast<char*>("add"), &function)}) {
      failed += code != 0;
    }
    const short unsupported = GT_EndHandwheel(1);
    failed += GT_Close() != 0;
    std::printf("failed %d, unsupported %d\n", failed, unsupported);
  }
} machine;

}  // namespace

int main() {
  if (GT_Open(0, 1) != 0 || GT_AxisOn(1) != 0) return 2;
  std::puts("the end");
  return 0;
}
