// Errors of object files: GT_Download's return codes, and texts that say where.
#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"

namespace oncard::vm {

/// GT_Download's return codes (GTS manual chapter 13).
inline constexpr int kObjectNotFound = 2007;
inline constexpr int kObjectDamaged = 2008;
inline constexpr int kTooManyFunctions = 7;

/// An error with code 2008.
template <typename... Args>
Error DamagedObject(std::string_view en, std::string_view zh, const Args&... args) {
  return MakeError(kObjectDamaged, en, zh, args...);
}

/// The same error with the place in front of its text.
inline Error At(const Message& place, const Error& error) {
  return {error.code,
          {fmt::format("{}: {}", place.en, error.message.en),
           fmt::format("{}：{}", place.zh, error.message.zh)}};
}

/// Untrusted text for a message: what is not printable ASCII as `\xNN`, truncated after 40 bytes.
inline std::string Printable(std::string_view text) {
  constexpr size_t kShown = 40;
  std::string printable;
  for (const char c : text.substr(0, kShown)) {
    if (c >= ' ' && c <= '~') {
      printable += c;
    } else {
      printable += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  if (text.size() > kShown) printable += "...";
  return printable;
}

}  // namespace oncard::vm
