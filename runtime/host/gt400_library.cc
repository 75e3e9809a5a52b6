// libgt400: the services of the host library for GT400 cards.
#include "gtcalls/gt400/family.h"
#include "runtime/host/library.h"

namespace oncard::runtime {
namespace {

int16_t GetCurrentCard(ServiceCall& call) {
  return static_cast<int16_t>(call.table.selected.load());
}

constexpr HostService kServices[] = {
    // command, before_open, function
    {"GT_Open", true, OpenCard},
    {"GT_Close", false, CloseCard},
    {"GT_Reset", false, ResetCard},
    {"GT_HardRst", false, ResetCard},
    {"GT_GetCurrentCardNo", true, GetCurrentCard},
    {"GT_SwitchtoCardNo", true, SelectCard},
};

}  // namespace

const HostLibrary& Library() {
  static const HostLibrary kLibrary = {.family = gtcalls::Gt400Family(), .services = kServices};
  return kLibrary;
}

}  // namespace oncard::runtime
