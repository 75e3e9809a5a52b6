// Commands that the host library executes itself instead of the card: opening and closing, program
// files, names and versions. Everything else goes to gtcalls::ExecuteCommand(). Tested by
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
  CardTable& table;
  CardSlot& slot;
  std::span<vm::CommandArgument> arguments;
  /// Why the call was refused, for the call log; set beside a code other than 0.
  Message reason;

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

/// The service that executes a command, or nullptr if the card does.
const HostService* FindHostService(const gtcalls::Command& command);

}  // namespace oncard::runtime
