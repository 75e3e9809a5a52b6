// What the host libraries of both GE families share: up to 16 cards of which one is current, and
// the handler of commands. Tested by tests/families/ge/ge_family_test.cc.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/host/services.h"

namespace oncard::runtime {

/// GT_Open means the current card if it is closed, else the lowest closed one; all other commands
/// mean the current one.
int GeCardOf(const gtcalls::Command& command, std::span<const HostArgument> arguments,
             CardTable& table);

/// GT_Open. The card becomes the current one.
int16_t OpenGeCard(ServiceCall& call);

/// GT_HookCommand.
int16_t HookCommand(ServiceCall& call);
/// HostLibrary::host_hears and tell_host, for its handler.
bool HostHearsGe(const gtcalls::Command& command);
void TellGeHost(std::string inputs, int16_t code);

/// The commands that both libraries execute themselves.
inline constexpr HostService kGeServices[] = {
    // command, before_open, function
    {"GT_Open", true, OpenGeCard},           {"GT_Close", false, CloseCard},
    {"GT_Reset", false, ResetCard},          {"GT_HardRst", false, ResetCard},
    {"GT_HookCommand", true, HookCommand},   {"GT_GetCurrentCardNo", true, GetSelectedCard},
    {"GT_SwitchtoCardNo", true, SelectCard},
};

}  // namespace oncard::runtime
