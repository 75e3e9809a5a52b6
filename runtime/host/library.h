// What the host library of one family has in addition to the code that all of them share. Each
// library defines it in a source of its own (gts_library.cc).
#pragma once

#include <cstdint>
#include <span>

#include "gtcalls/family.h"
#include "runtime/host/host_api.h"
#include "runtime/host/services.h"

namespace oncard::runtime {

struct HostLibrary {
  /// The family whose commands it has.
  const gtcalls::Family& family;
  /// The commands that it executes itself.
  std::span<const HostService> services;
  /// Gets the code of every call through a function without a card number; nullptr: nobody does.
  void (*notice_result)(const gtcalls::Command& command, std::span<const HostArgument> arguments,
                        int16_t code) = nullptr;
};

/// The library of this process.
const HostLibrary& Library();

inline const gtcalls::Family& LibraryFamily() { return Library().family; }

}  // namespace oncard::runtime
