// libtoy: the services of the family.
#include <atomic>
#include <string>
#include <utility>

#include "runtime/host/host_interrupts.h"
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

using Hearer = void (*)(const char* call, short code);
std::atomic<Hearer> hearer = nullptr;

int16_t Hook(ServiceCall& call) {
  *static_cast<Hearer*>(call.arguments[1].host) =
      hearer.exchange(reinterpret_cast<Hearer>(call.arguments[0].host));
  return vm::kOk;
}

bool HostHears(const gtcalls::Command& command) {
  return hearer != nullptr && command.name != "TOY_Hook";
}

void TellHost(std::string inputs, int16_t code) {
  if (const Hearer hears = hearer) hears(inputs.c_str(), code);
}

int16_t OnInterrupt(ServiceCall& call) {
  HostInterrupts::OfProcess().Answer(
      call.card(),
      {.handler = reinterpret_cast<void (*)()>(call.arguments[0].host), .event = nullptr});
  return vm::kOk;
}

int16_t SetEvent(ServiceCall& call) {
  HostInterrupts::OfProcess().Answer(
      call.card(), {.handler = nullptr, .event = InterruptEventOf(call.arguments[0].host)});
  return vm::kOk;
}

constexpr HostService kServices[] = {
    {"TOY_Open", true, OpenCard},
    {"TOY_Close", false, CloseCard},
    {"TOY_Call", false, CallHandler},
    {"TOY_Hook", true, Hook},
    {"TOY_OnInterrupt", false, OnInterrupt},
    {"TOY_SetEvent", false, SetEvent},
};

}  // namespace

const HostLibrary& Library() {
  static const HostLibrary kLibrary = {.family = gtcalls::ToyFamily(),
                                       .services = kServices,
                                       .host_hears = HostHears,
                                       .tell_host = TellHost};
  return kLibrary;
}

}  // namespace oncard::runtime
