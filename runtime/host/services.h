// Commands that a host library executes itself instead of the card: opening and closing, program
// files, names and versions. Everything else goes to the family's functions. Each library has a
// table of them (library.h); those that several families have are here. Tested by
// tests/runtime/host_api_test.cc and host_programs_test.cc.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "base/message.h"
#include "gtcalls/catalogue.h"
#include "runtime/host/card_table.h"
#include "vm/command_table.h"

namespace oncard::runtime {

/// A call in progress. The arguments have been checked for NULL.
struct ServiceCall {
  const gtcalls::Command& command;
  CardTable& table;
  CardSlot& slot;
  std::span<vm::CommandArgument> arguments;
  /// Why the call was refused, for the call log; set beside a code other than 0.
  Message reason;
  /// The card has executed the command.
  bool acted = false;

  /// The number of the card.
  int card() const { return static_cast<int>(&slot - table.slots.data()); }
  const char* text(size_t index) const { return static_cast<const char*>(arguments[index].host); }
  int16_t Refuse(int16_t code, Message why) {
    reason = std::move(why);
    return code;
  }
};

struct HostService {
  std::string_view command;
  bool before_open = false;  ///< may be called while the card is not open
  int16_t (*function)(ServiceCall& call) = nullptr;
};

/// The service of this library that executes a command, or nullptr if the card does.
const HostService* FindHostService(const gtcalls::Command& command);

/// Lets the card execute the command, for which it has a function: what the call does to the card
/// is in the records, and what it does to the host is up to the service.
int16_t ExecuteOnCard(ServiceCall& call);

/// Switches the card on, with the clock, the surroundings, the memory and the record that the
/// environment asks for. Refused with Family::open_failed if the card is open, or if what the
/// environment says cannot be used.
int16_t OpenCard(ServiceCall& call);
int16_t CloseCard(ServiceCall& call);
/// Controller::Reset().
int16_t ResetCard(ServiceCall& call);
/// From now on functions without a card number mean the card that the first argument names.
int16_t SelectCard(ServiceCall& call);
/// Returns the number of that card.
int16_t GetSelectedCard(ServiceCall& call);

}  // namespace oncard::runtime
