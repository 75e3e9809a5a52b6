// libgep: the services of the host library for GE cards for point-to-point motion. Tested by
// tests/families/ge/ge_family_test.cc.
#include "gtcalls/ge/gep_family.h"
#include "runtime/host/ge_library.h"

namespace oncard::runtime {

const HostLibrary& Library() {
  static const HostLibrary kLibrary = GeLibrary(gtcalls::GepFamily());
  return kLibrary;
}

}  // namespace oncard::runtime
