#include "compiler/literal.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <string>

namespace oncard::compiler {
namespace {

// A number with more digits before its point is out of range; one with more zeros after it is zero.
constexpr int64_t kPointMax = 18;
constexpr int64_t kExponentMax = 1'000'000'000;

int DigitOf(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  return (c | 0x20) - 'a' + 10;
}

// Adds digits to a literal; false if one of them is none of the base.
bool AddDigits(std::string_view digits, uint64_t base, Literal& literal) {
  for (const char c : digits) {
    if (std::isxdigit(static_cast<unsigned char>(c)) == 0) return false;
    const uint64_t digit = static_cast<uint64_t>(DigitOf(c));
    if (digit >= base) return false;
    literal.magnitude = std::min(kHuge, literal.magnitude * base + digit);
  }
  return true;
}

// Removes a suffix `u`, `l`, `ul` or `lu`. Returns whether it has a `u`, or nothing if it is none
// of these.
std::optional<bool> TakeSuffix(std::string_view& text) {
  const auto take = [&text](char wanted) {
    if (text.empty() || (text.back() | 0x20) != wanted) return false;
    text.remove_suffix(1);
    return true;
  };
  const bool first = take('u');
  const bool is_long = take('l');
  const bool second = take('u');
  if (first && second) return std::nullopt;
  if (!is_long && second) return std::nullopt;
  return first || second;
}

// The value of the digits after a backslash: `x1F` or up to three octal ones.
std::optional<int> EscapeValue(std::string_view digits) {
  Literal literal;
  const bool hexadecimal = !digits.empty() && digits[0] == 'x';
  if (hexadecimal) digits.remove_prefix(1);
  if (digits.empty() || (!hexadecimal && digits.size() > 3)) return std::nullopt;
  if (!AddDigits(digits, hexadecimal ? 16 : 8, literal)) return std::nullopt;
  if (literal.magnitude > UINT8_MAX) return std::nullopt;
  return static_cast<int8_t>(static_cast<uint8_t>(literal.magnitude));
}

// Doubles the decimal fraction 0.DDD in place and returns the digit carried before the point.
int DoubleFraction(std::string& digits) {
  int carry = 0;
  for (size_t i = digits.size(); i-- > 0;) {
    const int sum = 2 * (digits[i] - '0') + carry;
    digits[i] = static_cast<char>('0' + sum % 10);
    carry = sum / 10;
  }
  while (!digits.empty() && digits.back() == '0') digits.pop_back();
  return carry;
}

int64_t ParseExponent(std::string_view text) {
  if (text.empty()) return 0;
  const bool negative = text.front() == '-';
  if (text.front() == '-' || text.front() == '+') text.remove_prefix(1);
  int64_t value = 0;
  for (const char c : text) value = std::min(kExponentMax, value * 10 + (c - '0'));
  return negative ? -value : value;
}

}  // namespace

Literal ParseInteger(std::string_view digits) {
  Literal literal;
  literal.as_bits = digits.size() > 1 && (digits[1] | 0x20) == 'x';
  if (literal.as_bits) digits.remove_prefix(2);
  const uint64_t base = literal.as_bits ? 16 : 10;
  for (const char c : digits) {
    literal.magnitude = literal.magnitude * base + static_cast<uint64_t>(DigitOf(c));
    if (literal.magnitude >= kHuge / base) {
      literal.magnitude = kHuge;
      break;
    }
  }
  return literal;
}

std::optional<Literal> ParseIntegerOfC(std::string_view text) {
  const bool octal = text.size() > 1 && text[0] == '0';
  const char mark = octal ? static_cast<char>(text[1] | 0x20) : '\0';
  const std::optional<bool> suffix = TakeSuffix(text);
  if (!suffix) return std::nullopt;
  uint64_t base = octal ? 8 : 10;
  if (mark == 'x') base = 16;
  if (mark == 'b') base = 2;
  if (mark == 'x' || mark == 'b') text.remove_prefix(std::min<size_t>(2, text.size()));
  Literal literal;
  literal.as_bits = base != 10;
  if (text.empty() || !AddDigits(text, base, literal)) return std::nullopt;
  literal.is_unsigned = *suffix || (literal.as_bits && literal.magnitude > INT32_MAX);
  return literal;
}

std::string WithoutLeadingZero(std::string_view text) {
  const std::optional<Literal> value = ParseIntegerOfC(text);
  if (value && value->magnitude <= INT32_MAX) return std::to_string(value->magnitude);
  if (value && value->magnitude <= UINT32_MAX) return fmt::format("0x{:X}", value->magnitude);
  const size_t first = text.find_first_of("123456789");
  return first == std::string_view::npos ? "0" : std::string(text.substr(first));
}

Literal ParseFixed(std::string_view text) {
  Literal literal;
  literal.kind = Literal::Kind::kFixed;
  const size_t exponent_at = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, exponent_at);
  const int64_t exponent = ParseExponent(text.substr(std::min(exponent_at + 1, text.size())));

  // The value is 0.DIGITS times 10^point.
  std::string digits;
  const size_t dot = std::min(mantissa.find('.'), mantissa.size());
  digits.append(mantissa.substr(0, dot));
  if (dot < mantissa.size()) digits.append(mantissa.substr(dot + 1));
  int64_t point = static_cast<int64_t>(dot) + exponent;
  const size_t zeros = std::min(digits.find_first_not_of('0'), digits.size());
  digits.erase(0, zeros);
  point -= static_cast<int64_t>(zeros);
  if (digits.empty() || point < -kPointMax) return literal;
  if (point > kPointMax) {
    literal.magnitude = kHuge;
    return literal;
  }

  std::string fraction;
  if (point <= 0) {
    fraction = std::string(static_cast<size_t>(-point), '0') + digits;
  } else {
    const size_t whole = static_cast<size_t>(point);
    if (digits.size() < whole) digits.append(whole - digits.size(), '0');
    for (size_t i = 0; i < whole; ++i) {
      literal.magnitude = literal.magnitude * 10 + static_cast<uint64_t>(digits[i] - '0');
    }
    fraction = digits.substr(whole);
  }
  if (literal.magnitude >= kHuge >> (vm::kFractionBits + 1)) {
    literal.magnitude = kHuge;
    return literal;
  }
  for (int bit = 0; bit < vm::kFractionBits; ++bit) {
    literal.magnitude = literal.magnitude * 2 + static_cast<uint64_t>(DoubleFraction(fraction));
  }
  literal.magnitude += static_cast<uint64_t>(DoubleFraction(fraction));
  return literal;
}

std::optional<int> CharacterValue(std::string_view text) {
  if (text.size() < 3 || text.front() != '\'' || text.back() != '\'') return std::nullopt;
  text = text.substr(1, text.size() - 2);
  if (text.size() == 1) {
    const unsigned char character = static_cast<unsigned char>(text[0]);
    return character < 0x80 && character != '\\' ? std::optional<int>(character) : std::nullopt;
  }
  if (text.size() < 2 || text[0] != '\\') return std::nullopt;
  if (const std::optional<int> value = EscapeValue(text.substr(1))) return value;
  if (text.size() != 2) return std::nullopt;
  constexpr std::string_view kEscapes = "abtnvfr";  // 7 to 13
  const size_t escape = kEscapes.find(text[1]);
  if (escape != std::string_view::npos) return 7 + static_cast<int>(escape);
  if (std::string_view("'\"\\?").find(text[1]) != std::string_view::npos) return text[1];
  return std::nullopt;
}

std::optional<int32_t> IntValue(const Literal& literal) {
  if (literal.kind != Literal::Kind::kInteger) return std::nullopt;
  if (literal.invalid) return 0;
  if (literal.as_bits || literal.is_unsigned) {
    if (literal.magnitude > UINT32_MAX) return std::nullopt;
    const uint32_t bits = static_cast<uint32_t>(literal.magnitude);
    return static_cast<int32_t>(literal.negative ? 0 - bits : bits);
  }
  const int64_t value = literal.negative ? -static_cast<int64_t>(literal.magnitude)
                                         : static_cast<int64_t>(literal.magnitude);
  if (value < INT32_MIN || value > INT32_MAX) return std::nullopt;
  return static_cast<int32_t>(value);
}

std::optional<int64_t> FixedValue(const Literal& literal, vm::DoubleFormat format) {
  if (literal.invalid) return 0;
  int64_t raw = 0;
  if (literal.kind == Literal::Kind::kInteger) {
    const std::optional<int32_t> value = IntValue(literal);
    if (!value) return std::nullopt;
    raw = static_cast<int64_t>(*value) * (1 << vm::kFractionBits);
  } else {
    raw = static_cast<int64_t>(literal.magnitude);
    if (literal.negative) raw = -raw;
  }
  if (raw < vm::FixedMin(format) || raw > vm::FixedMax(format)) return std::nullopt;
  return raw;
}

}  // namespace oncard::compiler
