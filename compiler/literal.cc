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

// Reads digits into 64 bits; `bits` is empty if they do not fit. False if one is none of the base.
bool ReadDigits(std::string_view digits, uint64_t base, std::optional<uint64_t>* bits) {
  *bits = 0;
  for (const char c : digits) {
    if (std::isxdigit(static_cast<unsigned char>(c)) == 0) return false;
    const uint64_t digit = static_cast<uint64_t>(DigitOf(c));
    if (digit >= base) return false;
    if (!bits->has_value()) continue;
    if (**bits > (UINT64_MAX - digit) / base) {
      bits->reset();
    } else {
      *bits = **bits * base + digit;
    }
  }
  return true;
}

struct Suffix {
  bool is_unsigned = false;
  bool is_long_long = false;
};

// Removes a suffix of C: `u`, `l`, `ll`, or `u` with one of the others. Empty if it is none.
std::optional<Suffix> TakeSuffix(std::string_view& text) {
  const auto take = [&text](char wanted) {
    if (text.empty() || (text.back() | 0x20) != wanted) return false;
    text.remove_suffix(1);
    return true;
  };
  Suffix suffix;
  const bool last = take('u');
  const char l = text.empty() ? '\0' : text.back();
  const bool is_long = take('l');
  if (is_long && !text.empty() && text.back() == l) {
    suffix.is_long_long = true;
    text.remove_suffix(1);
  }
  const bool first = take('u');
  if (first && (last || !is_long)) return std::nullopt;
  suffix.is_unsigned = first || last;
  return suffix;
}

// The value of the digits after a backslash: `x1F` or up to three octal ones.
std::optional<int> EscapeValue(std::string_view digits) {
  const bool hexadecimal = !digits.empty() && digits[0] == 'x';
  if (hexadecimal) digits.remove_prefix(1);
  if (digits.empty() || (!hexadecimal && digits.size() > 3)) return std::nullopt;
  std::optional<uint64_t> bits;
  if (!ReadDigits(digits, hexadecimal ? 16 : 8, &bits)) return std::nullopt;
  if (!bits || *bits > UINT8_MAX) return std::nullopt;
  return static_cast<int8_t>(static_cast<uint8_t>(*bits));
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

std::optional<IntegerOfC> ReadIntegerOfC(std::string_view text) {
  const bool octal = text.size() > 1 && text[0] == '0';
  const char mark = octal ? static_cast<char>(text[1] | 0x20) : '\0';
  const std::optional<Suffix> suffix = TakeSuffix(text);
  if (!suffix) return std::nullopt;
  uint64_t base = octal ? 8 : 10;
  if (mark == 'x') base = 16;
  if (mark == 'b') base = 2;
  if (mark == 'x' || mark == 'b') text.remove_prefix(std::min<size_t>(2, text.size()));
  IntegerOfC integer;
  if (text.empty() || !ReadDigits(text, base, &integer.bits)) return std::nullopt;
  integer.decimal = base == 10;
  integer.is_unsigned = suffix->is_unsigned;
  integer.is_long_long = suffix->is_long_long;
  return integer;
}

std::optional<Literal> ParseIntegerOfC(std::string_view text) {
  const std::optional<IntegerOfC> integer = ReadIntegerOfC(text);
  if (!integer) return std::nullopt;
  Literal literal;
  literal.as_bits = !integer->decimal;
  literal.magnitude = std::min(kHuge, integer->bits.value_or(kHuge));
  literal.is_unsigned = integer->is_unsigned || (literal.as_bits && literal.magnitude > INT32_MAX);
  literal.invalid = integer->is_long_long;
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
