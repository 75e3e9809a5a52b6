// Reads numbers in text. There is one reader so that the same numbers are accepted everywhere:
// infinity and "not a number" are not numbers, unlike in the standard library; `inf` and `nan` are
// ordinary names. Independent of the locale and of the standard library. Tested by
// tests/base/number_test.cc.
#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string_view>
#include <system_error>

namespace oncard {

/// The whole text as a finite number: decimal, as in `12`, `-1.5`, `.5`, `2e3`, or hexadecimal of
/// at most 32 bits after `0x`; a sign may stand before either. Empty for anything else.
std::optional<double> ReadNumber(std::string_view text);

/// The decimal number that a text begins with, whatever follows it; 0 if there is none,
/// or if it is too large or too small for a double.
double ReadLeadingNumber(std::string_view text);
/// The same as a float: the nearest one to the text, which the nearest double might not lead to.
float ReadLeadingFloat(std::string_view text);

/// The whole text as a whole number that fits the type: digits of the base, after a `-` when the
/// type has a sign. Empty for anything else.
template <std::integral Number>
std::optional<Number> ReadWhole(std::string_view text, int base = 10) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, base);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

}  // namespace oncard
