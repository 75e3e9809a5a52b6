// The names of temporary files that file_writer.cc makes and file_steps.cc, or its like on another
// system, recognises.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace oncard {

// They are hidden and differ. Where the system has locks, a writer keeps its own locked or open, so
// that the next writer in the folder recognises those that were left behind.
inline constexpr std::string_view kTemporaryPrefix = ".oncard-";
inline constexpr std::string_view kTemporaryEnding = ".tmp";
/// 16 hexadecimal digits: a number of 64 bits.
inline constexpr size_t kTemporaryDigits = 16;

inline std::string TemporaryNameOf(const std::string& folder, uint64_t number) {
  return fmt::format("{}{}{:0{}x}{}", folder, kTemporaryPrefix, number, kTemporaryDigits,
                     kTemporaryEnding);
}

/// True for names that TemporaryNameOf() gives, without their folder.
inline bool IsTemporaryName(std::string_view name) {
  if (!name.starts_with(kTemporaryPrefix) || !name.ends_with(kTemporaryEnding)) return false;
  if (name.size() != kTemporaryPrefix.size() + kTemporaryDigits + kTemporaryEnding.size()) {
    return false;
  }
  const std::string_view digits = name.substr(kTemporaryPrefix.size(), kTemporaryDigits);
  return digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace oncard
