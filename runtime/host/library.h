// What the host library of one family has in addition to the code that all of them share. Each
// library defines it in a source of its own (gts_library.cc).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "gtcalls/family.h"
#include "runtime/host/host_api.h"
#include "runtime/host/services.h"

namespace oncard::runtime {

struct HostLibrary {
  /// The family whose commands it has.
  const gtcalls::Family& family;
  /// The commands that it executes itself.
  std::span<const HostService> services;
  /// The card that a call through a function without a card number means; nullptr: the selected
  /// one. A number of no card is one of a card that is not open. Called with no card locked.
  int (*card_of)(const gtcalls::Command& command, std::span<const HostArgument> arguments,
                 CardTable& table) = nullptr;
  /// Gets the code of every call through a function without a card number; nullptr: nobody does.
  void (*notice_result)(const gtcalls::Command& command, std::span<const HostArgument> arguments,
                        int16_t code) = nullptr;
  /// True if the host wants to hear of this command, which ends now; nullptr: of none. Called with
  /// the card locked.
  bool (*host_hears)(const gtcalls::Command& command) = nullptr;
  /// Tells the host of such a call, in the thread that has made it: the inputs as the call log
  /// writes them, and the code. The card is no longer locked and signals no longer wait, so the
  /// host may make calls; it does not hear of these.
  void (*tell_host)(std::string inputs, int16_t code) = nullptr;
  /// The host's handler for the interrupts of a card has returned; nullptr: nobody wants to know.
  /// Called as tell_host.
  void (*handler_returned)(int card) = nullptr;
};

/// The library of this process.
const HostLibrary& Library();

inline const gtcalls::Family& LibraryFamily() { return Library().family; }

}  // namespace oncard::runtime
