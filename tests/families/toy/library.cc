// libtoy: the services of the family.
#include "runtime/host/library.h"

namespace oncard::gtcalls {
const Family& ToyFamily();
}  // namespace oncard::gtcalls

namespace oncard::runtime {
namespace {

int16_t CallHandler(ServiceCall& call) {
  reinterpret_cast<void (*)(int)>(call.arguments[0].host)(call.card());
  return vm::kOk;
}

constexpr HostService kServices[] = {
    {"TOY_Open", true, OpenCard},
    {"TOY_Close", false, CloseCard},
    {"TOY_Call", false, CallHandler},
};

}  // namespace

const HostLibrary& Library() {
  static const HostLibrary kLibrary = {.family = gtcalls::ToyFamily(), .services = kServices};
  return kLibrary;
}

}  // namespace oncard::runtime
