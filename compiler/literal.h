// Number literals, read exactly: integers of 32 bits, and fixed-point numbers rounded to the
// nearest multiple of 2^-16 with decimal arithmetic, so that there is no intermediate binary
// rounding. Tested by tests/compiler/literal_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "vm/fixed_point.h"

namespace oncard::compiler {

/// A number as written, without its sign. Whether it fits depends on its sign and its use, which
/// are checked later.
struct Literal {
  enum class Kind : uint8_t { kInteger, kFixed };
  Kind kind = Kind::kInteger;
  /// Written as bits, in hexadecimal, octal or binary: up to 32 of them wrap to an int.
  bool as_bits = false;
  /// Structured C: the type is unsigned int, by its suffix, or because the bits do not fit an int.
  bool is_unsigned = false;
  /// It is not a number, or has been reported already; any value is accepted.
  bool invalid = false;
  /// The sign before it is part of it.
  bool negative = false;
  /// The magnitude: of an integer, or of the raw value (times 2^16) of a fixed-point number. Too
  /// large values are kHuge.
  uint64_t magnitude = 0;
};

/// The value of every magnitude that does not fit any type.
inline constexpr uint64_t kHuge = uint64_t{1} << 62;

/// Reads `12`, `0x1F` (suffixes removed). The digits must be well formed.
Literal ParseInteger(std::string_view digits);
/// A number of C that begins with 0 as one of the language, with the same value: 15 for `017`. The
/// digits without the zeros where C has no such number (`08`), or one that takes more than 32 bits.
std::string WithoutLeadingZero(std::string_view text);

/// An integer as C's preprocessor sees it.
struct IntegerOfC {
  std::optional<uint64_t> bits;  ///< empty if it has more than 64
  bool decimal = false;
  bool is_unsigned = false;   ///< its suffix has a `u`
  bool is_long_long = false;  ///< its suffix has `ll`
};
/// Reads `12`, `0x1F`, `0b101`, octal `017`, with a suffix of C: `12UL`, `12LL`. Empty for anything
/// else.
std::optional<IntegerOfC> ReadIntegerOfC(std::string_view text);
/// The same text as a number of structured C. One of long long, which it does not have, is invalid:
/// the preprocessor reports it where it is used.
std::optional<Literal> ParseIntegerOfC(std::string_view text);
/// Reads `12.5`, `.5`, `3.`, `1e-3`. Rounds half away from zero. The text must be well formed.
Literal ParseFixed(std::string_view text);

/// The value of `'x'` in C, with the quotes: one ASCII character or one of C's escapes. A char has
/// a sign: '\xFF' is -1.
std::optional<int> CharacterValue(std::string_view text);

/// The value as an int: decimal literals in the range of int; unsigned ones and those written as
/// bits up to 32 bits, which wrap. Empty for a fixed-point literal, or if it does not fit.
std::optional<int32_t> IntValue(const Literal& literal);
/// The raw value as a double of the given format. Empty if it does not fit.
std::optional<int64_t> FixedValue(const Literal& literal, vm::DoubleFormat format);

}  // namespace oncard::compiler
