// libges: the services of the host library for GE cards for paths. Tested by
// tests/families/ge/ge_family_test.cc.
#include "gtcalls/ge/ges_family.h"
#include "runtime/host/ge_library.h"

namespace oncard::runtime {

const HostLibrary& Library() {
  static const HostLibrary kLibrary = GeLibrary(gtcalls::GesFamily());
  return kLibrary;
}

}  // namespace oncard::runtime
