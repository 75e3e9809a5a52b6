// libges: the services of the host library for GE cards for paths. Tested by
// tests/families/ge/ge_family_test.cc.
#include "gtcalls/ge/ges_family.h"
#include "runtime/host/ge_library.h"
#include "runtime/host/library.h"

namespace oncard::runtime {

const HostLibrary& Library() {
  static const HostLibrary kLibrary = {.family = gtcalls::GesFamily(),
                                       .services = kGeServices,
                                       .card_of = GeCardOf,
                                       .host_hears = HostHearsGe,
                                       .tell_host = TellGeHost};
  return kLibrary;
}

}  // namespace oncard::runtime
