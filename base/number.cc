#include "base/number.h"

#include <fast_float/fast_float.h>

#include <cmath>
#include <cstdint>
#include <system_error>

namespace oncard {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// fast_float also reads words such as `inf`.
bool BeginsWithDigit(std::string_view text) {
  if (text.starts_with('.')) text.remove_prefix(1);
  return !text.empty() && IsDigit(text.front());
}

/// True if the decimal number underflows: the value is 0, but the text has another digit.
template <typename Number>
bool IsLost(std::string_view text, Number value) {
  return value == 0 && text.substr(0, text.find_first_of("eE")).find_first_of("123456789") !=
                           std::string_view::npos;
}

/// Returns the end of the decimal number at the beginning of the text, or the beginning of the text
/// if there is no number that the type can hold.
template <typename Number>
const char* ReadDecimal(std::string_view text, Number* value) {
  const auto [stop, error] = fast_float::from_chars(text.data(), text.data() + text.size(), *value);
  const std::string_view read(text.data(), static_cast<size_t>(stop - text.data()));
  if (error == std::errc() && std::isfinite(*value) && !IsLost(read, *value)) return stop;
  *value = 0;
  return text.data();
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
    if (ReadDecimal(text, &value) != text.data() + text.size()) return std::nullopt;
  }
  return negative ? -value : value;
}

double ReadLeadingNumber(std::string_view text) {
  double value = 0;
  ReadDecimal(text, &value);
  return value;
}

float ReadLeadingFloat(std::string_view text) {
  float value = 0;
  ReadDecimal(text, &value);
  return value;
}

}  // namespace oncard
