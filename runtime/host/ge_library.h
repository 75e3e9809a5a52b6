// What the host libraries of both GE families share: up to 16 cards of which one is current, the
// handler of commands, and the watch. Tested by tests/families/ge/ge_family_test.cc.
#pragma once

#include <cstdint>
#include <string>

#include "gtcalls/ge/watch.h"
#include "runtime/host/services.h"

namespace oncard::runtime {

/// GT_Open means the current card if it is closed, else the lowest closed one; all other commands
/// mean the current one.
int GeCardOf(const gtcalls::Command& command, CardTable& table);

/// GT_Open. The card becomes the current one.
int16_t OpenGeCard(ServiceCall& call);
/// GT_GetCurrentCardNo, which returns the number.
int16_t GetCurrentCard(ServiceCall& call);

/// GT_HookCommand.
int16_t HookCommand(ServiceCall& call);
/// HostLibrary::host_hears and tell_host, for its handler.
bool HostHearsGe(const gtcalls::Command& command);
void TellGeHost(std::string inputs, int16_t code);

/// TAxis, the arrays of the host for the values of one axis.
struct WatchedAxis {
  long* prf_pos;
  long* atl_pos;
  double* prf_vel;
  double* atl_vel;
  short* voltage;
};

/// GT_GetWatch, whose first argument refers to an array of WatchedAxis.
int16_t GetWatch(ServiceCall& call);

/// The commands that both libraries execute themselves.
inline constexpr HostService kGeServices[] = {
    // command, before_open, function
    {"GT_Open", true, OpenGeCard},           {"GT_Close", false, CloseCard},
    {"GT_Reset", false, ResetCard},          {"GT_HardRst", false, ResetCard},
    {"GT_HookCommand", true, HookCommand},   {"GT_GetCurrentCardNo", true, GetCurrentCard},
    {"GT_SwitchtoCardNo", true, SelectCard}, {"GT_GetWatch", false, GetWatch},
};

}  // namespace oncard::runtime
