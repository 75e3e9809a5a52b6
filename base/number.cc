#include "base/number.h"

#include <cstdint>

namespace oncard {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// from_chars() also knows words, such as `inf`.
bool BeginsWithDigit(std::string_view text) {
  if (text.starts_with('.')) text.remove_prefix(1);
  return !text.empty() && IsDigit(text.front());
}

}  // namespace

std::optional<double> ReadNumber(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (!BeginsWithDigit(text)) return std::nullopt;
  double value = 0;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    const auto bits = ReadWhole<uint32_t>(text.substr(2), 16);
    if (!bits) return std::nullopt;
    value = *bits;
  } else {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
  }
  return negative ? -value : value;
}

}  // namespace oncard
